! SPDX-License-Identifier: GPL-3.0-or-later
!> The one table that says which solver answers which scene.
module adfric_describe_scene_solvers
   use adfric_base_words, only: get_word, has_word
   implicit none (type, external)
   private
   public :: scenes, n_scenes, known_surfaces, known_tractions, known_extents, known_boundaries, known_curves, word_length
   public :: accuracy_of, accuracy_of_scene, answers, find_nearest

   !> Round bodies.
   character(*), parameter :: round = 'sphere,paraboloid,cone,power,flat_punch,flat_cone,flat_paraboloid,rounded_punch,'// &
      & 'rounded_cone,polynomial'
   !> Words of `&surface kind`, of `&traction kind` and of `&solid extent`.
   character(*), parameter :: known_surfaces = 'sphere paraboloid cone power flat_cone flat_paraboloid '// &
      & 'rounded_punch rounded_cone polynomial flat_punch ellipsoid cylinder line_punch wedge line_polynomial '// &
      & 'wave_1d wave_2d wave_product cosines profile heights spectrum'
   character(*), parameter :: known_tractions = 'line strip point rectangle', known_extents = 'half_space layer coating foundation'
   !> Words of `&solid boundaries`: how a surface of given heights goes on beyond its map.
   character(*), parameter :: known_boundaries = 'periodic free periodic_x periodic_y'
   !> Words of `&solid curve_modulus`: which modulus a master curve is one of.
   character(*), parameter :: known_curves = 'young contact'

   !> Surfaces, solids, interfaces, operations, solver, and whether its answers are `exact` (closed forms, roots, integrals and
   !> time stepping whose error is that of round-off), `numerical` (cells or collocation, with an estimate of the error) or those of a
   !> statistical `theory`, whose own error no estimate has.
   !> A scene is answered by the first row that has it and whose solver knows all names that the input gives.
   character(*), parameter :: scenes(*) = [character(200) :: &
      & 'paraboloid half_space adhesion press sphere exact', &
      & 'paraboloid half_space shear,adhesion+shear press,slide,tangential sphere exact', &
      & round//' half_space none,adhesion press indenter exact', &
      & 'sphere,paraboloid,cone,power,polynomial half_space adhesion press attracted_indenter numerical', &
      & 'paraboloid half_space none press sphere exact', &
      & round//' half_space shear,adhesion+shear press,slide,tangential indenter exact', &
      & round//' half_space coulomb press,tangential indenter exact', &
      & round//' half_space coulomb path indenter_history exact', &
      & 'sphere,paraboloid,cone,power,flat_cone,flat_paraboloid,rounded_punch,rounded_cone,polynomial half_space adhesion '// &
      & 'path adhesive_indenter_history exact', &
      & round//' relaxing none path indenter_time exact', &
      & round//' relaxing adhesion path adhesive_indenter_time numerical', &
      & 'paraboloid,ellipsoid half_space none press hertz exact', &
      & 'paraboloid,ellipsoid half_space coulomb press,tangential hertz exact', &
      & 'paraboloid,ellipsoid half_space coulomb path hertz_history exact', &
      & 'cylinder half_space none press hertz exact', &
      & 'cylinder half_space coulomb press,tangential hertz exact', &
      & 'cylinder half_space coulomb roll hertz exact', &
      & 'cylinder relaxing none slide,roll hertz exact', &
      & 'line_punch,cylinder,wedge,line_polynomial half_space none press rigid_punch exact', &
      & 'line_punch,wedge,line_polynomial half_space shear slide rigid_punch exact', &
      & 'wave_1d half_space none,adhesion press wave_1d exact', &
      & 'wave_1d half_space shear,adhesion+shear press,slide wave_1d exact', &
      & 'wave_1d half_space coulomb press,tangential wave_1d exact', &
      & 'wave_1d relaxing none,adhesion press,slide wave_1d exact', &
      & 'cylinder relaxing shear press,slide hertz exact', &
      & 'cylinder relaxing adhesion,adhesion+shear press,slide adhesive_cylinder exact', &
      & 'wave_1d relaxing shear press,slide wave_1d exact', &
      & 'wave_1d half_space none,adhesion press wave_1d_elastic numerical', &
      & 'wave_1d half_space coulomb press,tangential wave_1d_elastic numerical', &
      & 'wave_2d half_space none,adhesion press wave_2d_elastic numerical', &
      & 'wave_2d half_space shear,adhesion+shear press,slide wave_2d_elastic numerical', &
      & 'wave_2d half_space coulomb press,tangential wave_2d_elastic numerical', &
      & 'profile,heights half_space none,adhesion press surface_elastic numerical', &
      & 'profile,heights half_space shear,adhesion+shear press,slide surface_elastic numerical', &
      & 'profile,heights half_space coulomb press,tangential surface_elastic numerical', &
      & 'heights free_half_space none,adhesion press free_surface numerical', &
      & 'wave_1d,wave_2d,profile,heights relaxing none path surface_time numerical', &
      & 'wave_1d layer,coating none,adhesion,shear,adhesion+shear press wave_1d_elastic numerical', &
      & 'wave_2d layer,coating none,adhesion,shear,adhesion+shear press wave_2d_elastic numerical', &
      & 'profile,heights layer,coating none,adhesion,shear,adhesion+shear press surface_elastic numerical', &
      & 'wave_1d,wave_2d,profile,heights relaxing,layer none press,slide surface_sliding numerical', &
      & 'wave_1d,wave_2d,profile,heights relaxing,layer adhesion press,slide surface_sliding numerical', &
      & 'wave_1d,wave_product,cosines,profile,heights foundation none,adhesion press,slide wavy_sliding exact', &
      & 'wave_1d,wave_2d,profile,heights relaxing,layer shear,adhesion+shear press,slide surface_sliding numerical', &
      & 'wave_1d,wave_product,cosines,profile,heights foundation shear,adhesion+shear press,slide wavy_sliding exact', &
      & 'wave_1d layer,coating shear,adhesion+shear slide wave_1d_elastic numerical', &
      & 'wave_2d layer,coating shear,adhesion+shear slide wave_2d_elastic numerical', &
      & 'profile,heights layer,coating shear,adhesion+shear slide surface_elastic numerical', &
      & 'cylinder,ellipsoid half_space shear slide hertz exact', &
      & 'wave_1d,wave_2d,profile,heights half_space shear press,slide surface_sliding numerical', &
      & 'spectrum half_space none,adhesion press rough_theories theory', &
      & 'spectrum relaxing none slide rough_theories theory', &
      & 'spectrum half_space none,adhesion press spectrum_elastic numerical', &
      & 'spectrum half_space shear,adhesion+shear press,slide spectrum_elastic numerical', &
      & 'spectrum half_space coulomb press,tangential spectrum_elastic numerical', &
      & 'spectrum layer,coating none,adhesion,shear,adhesion+shear press spectrum_elastic numerical', &
      & 'spectrum layer,coating shear,adhesion+shear slide spectrum_elastic numerical', &
      & 'line half_space none press,tangential line_load exact', &
      & 'strip half_space none press strip_load exact', &
      & 'point half_space none press,tangential point_load exact', &
      & 'rectangle half_space none press rectangle_load exact']
   integer, parameter :: n_scenes = size(scenes)

   !> Length of the words of a scene.
   integer, parameter :: word_length = 20

contains

   !> Are the answers of a solver exact, numerical, or those of a theory?
   pure function accuracy_of(solver) result(word)
      !> Name of the solver.
      character(*), intent(in) :: solver
      character(:), allocatable :: word
      integer :: row

      word = ''
      do row = 1, n_scenes
         if (get_word(scenes(row), 5) == solver) word = get_word(scenes(row), 6)
      end do
   end function accuracy_of

   !> Is the answer to a scene exact or numerical? Empty if nothing solves it.
   pure function accuracy_of_scene(words) result(word)
      !> Surface, solid, interface and operation.
      character(*), intent(in) :: words(4)
      character(:), allocatable :: word
      integer :: row

      do row = 1, n_scenes
         if (.not. answers(row, words)) cycle
         word = get_word(scenes(row), 6)
         return
      end do
      word = ''
   end function accuracy_of_scene

   !> Does a row of the table have a scene?
   pure logical function answers(row, words)
      !> Number of the row.
      integer, intent(in) :: row
      !> Surface, solid, interface and operation.
      character(*), intent(in) :: words(4)

      answers = count_differences(row, words) == 0
   end function answers

   !> Is an item on a list?
   pure logical function has_item(list, item)
      !> Items, separated by a comma.
      character(*), intent(in) :: list
      character(*), intent(in) :: item

      has_item = index(','//list//',', ','//item//',') > 0
   end function has_item

   !> The scene of the table that is nearest to one that no row has: with the fewest differences, the surface kept before the solid,
   !> the solid before the interface, and that before the operation.
   pure subroutine find_nearest(words, nearest, solvers)
      !> Surface, solid, interface and operation.
      character(*), intent(in) :: words(4)
      !> Receives those of the nearest scene.
      character(*), intent(out) :: nearest(4)
      !> Names of solvers that may answer it, separated by a blank. Not given: all.
      character(*), intent(in), optional :: solvers
      character(:), allocatable :: list
      integer :: distances(n_scenes), row, k

      distances = [(count_differences(k, words), k=1, n_scenes)]
      if (present(solvers)) then
         do k = 1, n_scenes
            if (.not. has_word(solvers, get_word(scenes(k), 5))) distances(k) = huge(1)
         end do
      end if
      row = minloc(distances, 1)
      do k = 1, 4
         list = get_word(scenes(row), k)
         nearest(k) = words(k)
         if (.not. has_item(list, trim(words(k)))) nearest(k) = list(:scan(list//',', ',') - 1)
      end do
      if (is_kin_of_heights(row, words)) nearest(1) = 'heights'
      ! over a solid that relaxes a contact is solved while it slides: the solver asks for the velocity
      if (index(nearest(2), 'half_space') == 0 .and. nearest(4) == 'press' .and. index(get_word(scenes(row), 5), '_elastic') == 0) &
         & nearest(4) = 'slide'
   end subroutine find_nearest

   !> How far a row is from a scene: 0 if it has it.
   pure integer function count_differences(row, words) result(distance)
      !> Number of the row.
      integer, intent(in) :: row
      !> Surface, solid, interface and operation.
      character(*), intent(in) :: words(4)
      integer, parameter :: weights(4) = [1000, 103, 102, 101]
      integer :: k

      distance = 0
      do k = 1, 4
         if (.not. has_item(get_word(scenes(row), k), trim(words(k)))) distance = distance + weights(k)
      end do
      ! a surface known by its spectrum is most like one of heights
      if (is_kin_of_heights(row, words)) distance = distance - 1
   end function count_differences

   !> Is the surface of a scene known by its spectrum alone, and has a row heights?
   pure logical function is_kin_of_heights(row, words)
      !> Number of the row.
      integer, intent(in) :: row
      !> Surface, solid, interface and operation.
      character(*), intent(in) :: words(4)

      is_kin_of_heights = words(1) == 'spectrum' .and. has_item(get_word(scenes(row), 1), 'heights')
   end function is_kin_of_heights

end module adfric_describe_scene_solvers
