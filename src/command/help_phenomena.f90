! SPDX-License-Identifier: GPL-3.0-or-later
!> What `adfric help` knows by the names of phenomena and authors: which words of an input, which shipped inputs and which page.
module adfric_command_help_phenomena
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_base_text, only: join_words, newline
   implicit none (type, external)
   private
   public :: describe_phenomena, list_phenomena, show_phenomena

   !> Columns of the table: names, what it is, words of an input, shipped inputs, and pages of the documents.
   integer, parameter :: names = 1, meaning = 2, scene = 3, inputs = 4, pages = 5, n_columns = 5
   !> Number of rows of the table.
   integer, parameter :: n_rows = 30
   !> One row for each phenomenon. Names, inputs and pages are separated by a blank; a name may stand in several rows.
   character(*), parameter :: table(n_columns, n_rows) = reshape([character(160) :: &
      & 'hertz', 'smooth bodies pressed together, without adhesion (Hertz)', &
      & '&surface kind = ''sphere'', ''paraboloid'', ''ellipsoid'' or ''cylinder''; no &adhesion', &
      & 'hertz_axes hertz_ratio', 'theory/hertz theory/round_contact', &
      & 'jkr johnson kendall roberts', 'round bodies that adhere over a short range (Johnson, Kendall, Roberts)', &
      & '&adhesion work_of_adhesion alone', &
      & 'hertz_jkr lecture_jkr johnson1997_fig5_jkr', 'theory/round_adhesion', &
      & 'maugis dugdale', 'round bodies that adhere with a constant stress up to a range (Maugis, Dugdale)', &
      & '&adhesion work_of_adhesion with lambda, adhesion_stress or adhesion_range', &
      & 'johnson1997_fig3 johnson1997_fig5', 'theory/round_adhesion', &
      & 'dmt derjaguin muller toporov bradley', 'stiff round bodies that adhere over a long range (Derjaguin, Muller, Toporov)', &
      & '&adhesion theory = ''dmt''', 'johnson1997_lambda pulloff_map_load', 'theory/round_adhesion', &
      & 'tabor tabor_parameter', 'from DMT to JKR: Tabor''s parameter times 1.157 is lambda', &
      & '&adhesion work_of_adhesion, lambda', 'johnson1997_lambda pulloff_map_load', 'theory/round_adhesion', &
      & 'pull_off snap_in snap_off', 'where surfaces that adhere jump apart, or into contact', &
      & '&output events = .true. (round bodies), pull_off = .true. (waves, surfaces)', &
      & 'indenter_pull_off wave_1d_pull_off surface_stickiness', &
      & 'theory/round_branches theory/adhesive_wave guide/pull_off_of_a_rough_surface', &
      & 'sneddon galin', 'indenters of any axisymmetric shape (Galin, Sneddon)', &
      & '&surface kind = ''cone'', ''power'', ''polynomial'', ''flat_punch'' and others', &
      & 'indenter_cone indenter_power indenter_flat', 'theory/round_contact', &
      & 'cattaneo mindlin jaeger ciavarella partial_slip', &
      & 'partial slip below Coulomb''s limit (Cattaneo, Mindlin; Jaeger, Ciavarella)', &
      & '&friction coulomb_coefficient; &operating tangential_force or tangential_stress', &
      & 'hertz_slip indenter_slip wave_1d_slip surface_slip', 'theory/slip theory/round_friction theory/periodic_slip', &
      & 'fretting deresiewicz', 'energy that an oscillating tangential force loses (Mindlin, Deresiewicz)', &
      & '&friction coulomb_coefficient; &history loads, tangential_forces', &
      & 'hertz_hysteresis indenter_fretting', 'guide/fretting theory/round_history', &
      & 'amontons coulomb', 'friction in proportion to the load (Amontons, Coulomb)', &
      & '&friction coulomb_coefficient', 'hertz_slip wave_1d_slip', 'theory/slip', &
      & 'bowden tabor', 'friction in proportion to the area: a shear strength (Bowden, Tabor)', &
      & '&friction shear_strength; &operating state = ''sliding''', &
      & 'johnson1997_fig5 indenter_friction', 'theory/round_friction guide/friction_of_a_tip', &
      & 'johnson savkoor briggs peeling', 'a tangential force that peels a contact (Savkoor, Briggs; Johnson)', &
      & '&friction law = ''peeling'', or interaction with slip_energy_ratio', &
      & 'indenter_peeling johnson1997_fig9b johnson1997_savkoor', 'theory/round_peeling theory/johnson1997', &
      & 'stick_slip', 'stick-slip of a tip on a lateral spring', &
      & '&operating lateral_stiffness, base_displacement; &output events = .true.', &
      & 'stick_slip', 'theory/stick_slip', &
      & 'schallamach', 'bonds that stretch, break and rest (Schallamach)', &
      & '&friction law = ''bonds''; &operating velocity', '', 'theory/interface', &
      & 'eyring prandtl tomlinson', 'thermal jumps over a barrier that stress lowers (Eyring; Prandtl, Tomlinson)', &
      & '&friction law = ''activated''; &operating velocity, temperature', '', 'theory/interface', &
      & 'grosch rubber', 'rubber: losses of the solid and friction of the interface over velocity and temperature', &
      & '&solid master_curve or young_moduli; &friction law = ''log_gaussian''; &operating velocity', &
      & 'rubber_velocity rubber_all_parts wave_1d_interface', 'guide/rubber_on_a_road theory/interface', &
      & 'maxwell kelvin voigt zener prony', 'viscoelastic solids as springs and dashpots (Maxwell, Zener, Prony)', &
      & '&solid moduli or young_moduli or stiffnesses, with relaxation_times', &
      & 'rubber_master_curve soft_dwell', 'theory/columns_material theory/round_time', &
      & 'wlf williams landel ferry', 'shift of relaxation times with the temperature (Williams, Landel, Ferry)', &
      & '&solid shift = ''wlf'', wlf_c1, wlf_c2, reference_temperature; &operating temperature', &
      & 'rubber_velocity', 'theory/columns_material', &
      & 'goryacheva makhovskaya winkler', 'adhesion in the friction of columns that relax (Goryacheva, Makhovskaya)', &
      & '&solid extent = ''foundation''; &adhesion; &operating velocity', &
      & 'gm2011_fig4_reconciled gm2011_fig5 gm2011_fig6', 'theory/columns theory/columns_strips', &
      & 'carter creepage rolling', 'a wheel that drives by friction, with creepage (Carter)', &
      & '&surface kind = ''cylinder''; &friction coulomb_coefficient; &operating state = ''rolling''', &
      & 'cylinder_rolling', 'theory/rolling', &
      & 'hunter', 'cylinders and waves that slide or roll over a viscoelastic solid (Hunter; Goryacheva)', &
      & '&surface kind = ''cylinder'' or ''wave_1d''; &solid with relaxation; &operating velocity', &
      & 'hertz_line_sliding wave_1d_sliding', 'theory/line_sliding', &
      & 'ting lee radok', 'indenters on viscoelastic solids in time (Lee, Radok; Ting)', &
      & '&solid with relaxation; &history', 'soft_dwell soft_creep soft_oscillation', 'guide/soft_samples theory/round_time', &
      & 'ageing aging', 'contacts that grow while they rest', &
      & '&solid with relaxation; &history times, mean_pressures', 'rough_ageing', 'guide/ageing_of_a_contact theory/ageing', &
      & 'flash blok carslaw', 'heat of sliding and flash temperatures (Blok; Carslaw, Jaeger)', &
      & '&heat conductivity, second_conductivity, density, heat_capacity; &operating velocity', &
      & 'rubber_flash_temperature ball_flash_temperature', 'theory/heat', &
      & 'westergaard', 'a wave on an elastic half-plane (Westergaard)', &
      & '&surface kind = ''wave_1d''; &operating mean_pressure', 'wave_1d wave_1d_pressure', 'theory/waves', &
      & 'boussinesq cerruti', 'a point force on an elastic half-space (Boussinesq, Cerruti)', &
      & '&traction kind = ''point''; &operating load, tangential_force', 'point_load', 'theory/line_contacts', &
      & 'love rectangle', 'a constant pressure on a rectangle of an elastic half-space (Love)', &
      & '&traction kind = ''rectangle''; pressure, half_width_x, half_width_y', 'rectangle_load', 'theory/line_contacts', &
      & 'flamant', 'a line load on an elastic half-plane (Flamant)', &
      & '&traction kind = ''line''; &operating load, tangential_force', 'line_load', 'theory/line_contacts', &
      & 'roughness rough greenwood', 'rough surfaces: area, pressure and pull-off of measured or made heights', &
      & '&surface kind = ''heights'' or ''profile''', 'surface_elastic surface_stickiness rubber_map', &
      & 'theory/periodic_contact theory/periodic_adhesion guide/import', &
      & 'spectrum psd persson roughness road rubber bush gibson thomas nayak', &
      & 'rough surfaces by statistical theories of their power spectrum (Persson; Bush, Gibson, Thomas)', &
      & '&surface kind = ''spectrum'', seeds; &power_spectrum; &estimates theories; &operating mean_pressure, velocity', &
      & 'theories_pressure theories_of_map theories_rubber spectrum_seeds spectrum_ensemble', &
      & 'theory/rough_theories guide/from_a_spectrum_to_friction', &
      & 'afm force_curve cantilever', 'force curves and force maps of a force microscope, and their fits', &
      & '&data file, abscissa, ordinate; &free variable', 'fit_force_distance fit_map force_map', &
      & 'guide/fit_of_a_force_map guide/fit'], [n_columns, n_rows])

contains

   !> What is known of a phenomenon or an author; empty if the name stands in no row.
   pure function describe_phenomena(topic) result(text)
      !> A name in small letters; a hyphen or a blank counts as _.
      character(*), intent(in) :: topic
      character(:), allocatable :: text
      character(len(topic)) :: name
      integer :: i

      name = topic
      do i = 1, len(name)
         if (scan(name(i:i), '- ') > 0) name(i:i) = '_'
      end do
      text = ''
      do i = 1, n_rows
         if (.not. has_word(trim(table(names, i)), name)) cycle
         if (len(text) > 0) text = text//newline
         text = text//describe_row(i)
      end do
   end function describe_phenomena

   !> The lines of a row.
   pure function describe_row(i) result(text)
      !> Number of the row.
      integer, intent(in) :: i
      character(:), allocatable :: text

      text = trim(table(meaning, i))//newline//'  write   '//trim(table(scene, i))//newline
      if (count_words(table(inputs, i)) > 0) text = text//'  inputs  '//list_files('inputs/', table(inputs, i), '.nml')//newline
      text = text//'  pages   '//list_files('docs/', table(pages, i), '.md')//newline
   end function describe_row

   !> Names of files, with a comma between them.
   pure function list_files(folder, list, ending) result(text)
      !> What stands before each name, and behind it.
      character(*), intent(in) :: folder, ending
      !> Names, separated by a blank.
      character(*), intent(in) :: list
      character(:), allocatable :: text
      integer :: k

      text = ''
      do k = 1, count_words(list)
         if (k > 1) text = text//', '
         text = text//folder//get_word(list, k)//ending
      end do
   end function list_files

   !> What each row is, with its names below.
   pure function show_phenomena() result(text)
      character(:), allocatable :: text
      integer :: i

      text = 'Phenomena and authors; adfric help NAME says what to write, which inputs and which pages'//newline
      do i = 1, n_rows
         text = text//'  '//trim(table(meaning, i))//newline//'      '//join_words(trim(table(names, i)), ', ')//newline
      end do
   end function show_phenomena

   !> Every name of the table, once, separated by a blank.
   pure function list_phenomena() result(list)
      character(:), allocatable :: list
      integer :: i, k

      list = ''
      do i = 1, n_rows
         do k = 1, count_words(table(names, i))
            if (.not. has_word(list, get_word(table(names, i), k))) list = list//' '//get_word(table(names, i), k)
         end do
      end do
   end function list_phenomena

end module adfric_command_help_phenomena
