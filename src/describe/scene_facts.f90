! SPDX-License-Identifier: GPL-3.0-or-later
!> The facts of a scene that decide which solver answers it and which of its results have a meaning.
module adfric_describe_scene_facts
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_describe_scene_solvers, only: word_length
   implicit none (type, external)
   private
   public :: scene_t, find_facts, words_of, describe_scene, is_named

   !> What an input says of its scene.
   type :: scene_t
      !> Names `group%name` that are given, separated by a blank; of what is swept, the name
      !> may stand without its group.
      character(:), allocatable :: names
      !> Word of `&surface kind`, or of `&traction kind` where loads are given; empty if there is none.
      character(:), allocatable :: surface
      !> Word of `&solid extent`.
      character(:), allocatable :: extent
      !> Word of `&solid boundaries`; empty or not allocated if there is none, and the surface is periodic if it has given heights.
      character(:), allocatable :: boundaries
      !> Words of `&operating state` and of `&adhesion theory`; empty if there is none.
      character(:), allocatable :: state, theory
      !> Word of `&solid curve_modulus`; empty or not allocated if there is none.
      character(:), allocatable :: curve
      !> Words of `&estimates theories`, separated by a blank; empty or not allocated if there are none.
      character(:), allocatable :: theories
      !> Is the number of seeds 1, so that a point is one surface?
      logical :: is_single = .false.
      !> Does the scene say that shear stress does not move the contact?
      logical :: is_uncoupled = .false.
      !> One of: `half_space`, `relaxing`, `layer`, `coating`, `foundation`; with `free_` before it where boundaries are not
      !> periodic.
      character(:), allocatable :: solid
      !> One of: `none`, `adhesion`, `shear`, `coulomb`, `adhesion+shear`, `adhesion+coulomb`.
      character(:), allocatable :: interface
      !> One of: `press`, `slide`, `tangential`, `roll`, `path`.
      character(:), allocatable :: operation
      !> All facts, separated by a blank.
      character(:), allocatable :: facts
   contains
      procedure :: has
   end type scene_t

   !> A fact, and the names that it follows from.
   character(*), parameter :: signs(*) = [character(200) :: &
      & 'adhesion adhesion%work_of_adhesion adhesion%adhesion_stress adhesion%adhesion_range adhesion%lambda '// &
      & 'adhesion%law adhesion%tension_table job%units', &
      & 'work_given adhesion%work_of_adhesion', &
      & 'stress_given adhesion%adhesion_stress', &
      & 'opens adhesion%opening_work_of_adhesion', &
      & 'range_given adhesion%adhesion_range', &
      & 'range adhesion%adhesion_stress adhesion%adhesion_range adhesion%lambda job%units', &
      & 'shear friction%shear_strength friction%law', &
      & 'strength friction%shear_strength', &
      & 'heat heat%conductivity heat%density heat%heat_capacity heat%second_conductivity', &
      & 'coulomb friction%coulomb_coefficient', &
      & 'coupled friction%coupling', &
      & 'tangential operating%tangential_force operating%tangential_displacement operating%tangential_stress '// &
      & 'operating%base_displacement history%tangential_forces history%tangential_displacements', &
      & 'path history%loads history%approaches history%base_approaches history%times history%path '// &
      & 'history%mean_pressures history%tangential_forces history%tangential_displacements', &
      & 'oscillates history%frequency', &
      & 'relaxes solid%modulus solid%moduli solid%young_moduli solid%relaxation_times solid%relaxation_time solid%master_curve '// &
      & 'solid%power_law_modulus solid%power_law_exponent', &
      & 'young solid%young_modulus solid%young_moduli', &
      & 'events output%events', &
      & 'driven operating%base_displacement friction%law', &
      & 'pull_off output%pull_off', &
      & 'stiffness_wanted output%stiffness', &
      & 'plastic solid%hardness', &
      & 'stresses output%largest_stresses position%position_z solid%yield_strength', &
      & 'all_depths output%largest_stresses solid%yield_strength', &
      & 'yields solid%yield_strength', &
      & 'electrical solid%resistivity solid%second_resistivity', &
      & 'thermal solid%thermal_conductivity solid%second_thermal_conductivity', &
      & 'compared output%compare_branches', &
      & 'tilts operating%tilt', &
      & 'peels friction%interaction friction%law', &
      & 'face surface%face_half_width', &
      & 'spring operating%lateral_stiffness', &
      & 'machine operating%base_approach operating%machine_stiffness', &
      & 'moves operating%velocity', &
      & 'ensemble surface%seeds', &
      & 'pressure_given operating%mean_pressure', &
      & 'position position%position_x position%position_y position%position_z']

   !> Words of a scene, and what is said of it.
   character(*), parameter :: phrases(*) = [character(70) :: &
      & 'half_space on an elastic half-space', 'relaxing on a viscoelastic half-space', 'layer on a layer', &
      & 'coating on a coated half-space', 'foundation on a foundation', &
      & 'free_half_space on an elastic half-space with free boundaries', &
      & 'free_relaxing on a viscoelastic half-space with free boundaries', &
      & 'free_layer on a layer with free boundaries', 'free_coating on a coated half-space with free boundaries', &
      & 'free_foundation on a foundation with free boundaries', &
      & 'adhesion with adhesion', 'shear with a shear strength', 'coulomb with a coefficient of friction', &
      & 'adhesion+shear with adhesion and a shear strength', 'adhesion+coulomb with adhesion and a coefficient of friction', &
      & 'press pressed', 'slide sliding', 'tangential under a tangential force', 'path along a path of loading', &
      & 'roll rolling']

contains

   !> Find what follows from names and words.
   pure subroutine find_facts(self)
      !> In: names, surface, extent and state. Out: all.
      type(scene_t), intent(inout) :: self
      integer :: i, k
      logical :: slides

      self%facts = trim(self%surface//' '//self%extent)
      do i = 1, size(signs)
         do k = 2, count_words(signs(i))
            if (.not. is_named(self%names, get_word(signs(i), k))) cycle
            if (self%is_uncoupled .and. get_word(signs(i), 1) == 'coupled') cycle
            if (self%is_single .and. get_word(signs(i), 1) == 'ensemble') cycle
            self%facts = self%facts//' '//get_word(signs(i), 1)
            exit
         end do
      end do
      if (allocated(self%theory)) then
         if (len(self%theory) > 0 .and. self%theory /= 'auto') self%facts = self%facts//' range'
      end if
      if (allocated(self%theories)) then
         do k = 1, count_words(self%theories)
            self%facts = self%facts//' by_'//get_word(self%theories, k)
         end do
      end if
      if (is_named(self%names, 'solid%master_curve')) self%facts = self%facts//trim(fact_of_curve(self))

      slides = self%has('moves') .or. self%state == 'sliding'
      if (slides) self%facts = self%facts//' slides'
      if (slides .or. self%has('shear')) self%facts = self%facts//' interface'
      if (self%has('events') .and. self%has('shear')) self%facts = self%facts//' lateral'

      self%solid = self%extent
      if (self%extent == 'half_space' .and. self%has('relaxes')) self%solid = 'relaxing'
      if (self%solid == 'relaxing') self%facts = self%facts//' relaxing'
      if (has_border(self)) self%solid = 'free_'//self%solid
      self%interface = 'none'
      if (self%has('adhesion')) self%interface = 'adhesion'
      if (self%has('shear') .or. self%has('coulomb')) then
         self%interface = trim(merge('coulomb', 'shear  ', self%has('coulomb')))
         if (self%has('adhesion')) self%interface = 'adhesion+'//self%interface
      end if
      if (self%interface == 'none' .and. is_named(self%names, 'solid%poisson_ratio')) self%facts = self%facts//' may_stick'
      if (has_word('flat_punch cone paraboloid power', self%surface)) self%facts = self%facts//' of_one_power'
      self%operation = 'press'
      if (self%has('tangential')) self%operation = 'tangential'
      if (slides) self%operation = 'slide'
      if (self%state == 'rolling') then
         self%operation = 'roll'
         self%facts = self%facts//' rolls'
      end if
      if (self%has('path')) self%operation = 'path'
   end subroutine find_facts

   !> Does the surface end somewhere, in one direction at least?
   pure logical function has_border(self)
      type(scene_t), intent(in) :: self

      has_border = .false.
      if (allocated(self%boundaries)) has_border = len(self%boundaries) > 0 .and. self%boundaries /= 'periodic'
   end function has_border

   !> Which modulus a master curve is one of, as a fact behind a blank. With a Poisson's ratio it is Young's, unless the scene says
   !> that it is the contact modulus.
   pure function fact_of_curve(self) result(fact)
      type(scene_t), intent(in) :: self
      character(14) :: fact
      character(:), allocatable :: curve

      curve = ''
      if (allocated(self%curve)) curve = self%curve
      if (len(curve) == 0 .and. is_named(self%names, 'solid%poisson_ratio')) curve = 'young'
      fact = ''
      if (curve == 'young') fact = ' young'
      if (curve == 'contact') fact = ' contact_curve'
   end function fact_of_curve

   !> Is a variable named, with its group or, as in a sweep, without?
   pure logical function is_named(names, name)
      !> Names that are given.
      character(*), intent(in) :: names
      !> The variable with its group.
      character(*), intent(in) :: name

      is_named = has_word(names, name) .or. has_word(names, name(index(name, '%') + 1:))
   end function is_named

   !> Is something a fact of a scene?
   pure logical function has(self, fact)
      class(scene_t), intent(in) :: self
      !> The fact.
      character(*), intent(in) :: fact

      has = has_word(self%facts, fact)
   end function has

   !> Surface, solid, interface and operation.
   pure function words_of(self) result(words)
      !> The scene, with its facts.
      type(scene_t), intent(in) :: self
      character(word_length) :: words(4)

      words = [character(word_length) :: self%surface, self%solid, self%interface, self%operation]
   end function words_of

   !> A scene in words.
   pure function describe_scene(words) result(text)
      !> Surface, solid, interface and operation.
      character(*), intent(in) :: words(4)
      character(:), allocatable :: text, word
      integer :: i, k

      text = trim(words(1))
      do k = 2, 4
         if (k == 4) text = text//','
         do i = 1, size(phrases)
            word = get_word(phrases(i), 1)
            if (word == words(k)) text = text//trim(phrases(i)(len(word) + 1:))
         end do
      end do
   end function describe_scene

end module adfric_describe_scene_facts
