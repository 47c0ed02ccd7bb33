! SPDX-License-Identifier: GPL-3.0-or-later
!> Stresses in depth below a periodic surface on an elastic half-space: the rows that ask for them, what they cannot stand beside, the
!> results and the maps.
module adfric_periodic_stress_rows
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_describe_rows, only: above_zero, positive, result_row, switch
   use adfric_describe_table, only: profile_t, result_t, variable_t
   use adfric_periodic_stress_field, only: n_stresses
   implicit none (type, external)
   private
   public :: set_stress_rows, wants_stresses, wants_search, has_depth, check_stresses, stress_results, stress_profiles
   public :: n_stress_rows, n_stress_results, n_stress_profiles, stress_input, stress_output

   !> Rows in their order; a component is the index of its row.
   type :: stress_input_t
      !> Indices of the rows.
      integer :: largest = 0, depth = 0, strength = 0
   end type stress_input_t
   type(stress_input_t), parameter :: stress_input = transfer(counting, stress_input_t())
   integer, parameter :: n_stress_rows = storage_size(stress_input)/storage_size(1)
   !> Results in their order: of each measure its largest value, and depth, x and y of that; a component is the index of its row.
   type :: stress_output_t
      !> Indices of the rows.
      integer :: von_mises(4) = 0, shear(4) = 0, search_error = 0, yield_ratio = 0
   end type stress_output_t
   type(stress_output_t), parameter :: stress_output = transfer(counting, stress_output_t())
   integer, parameter :: n_stress_results = storage_size(stress_output)/storage_size(1)
   !> Maps: both measures, and all stresses.
   integer, parameter :: n_stress_profiles = 2 + n_stresses

contains

   !> The rows.
   subroutine set_stress_rows(rows)
      !> Receives the rows; shape `(n_stress_rows)`.
      type(variable_t), intent(out) :: rows(:)

      rows(stress_input%largest) = switch(group='output', name='largest_stresses', &
         & meaning='find the largest von Mises and shear stress in the solid, over all depths', default=.false.)
      rows(stress_input%depth) = above_zero(group='position', name='position_z', unit='m', &
         & meaning='depth at which the largest von Mises and shear stress are found, and whose stresses are profiles')
      rows(stress_input%strength) = positive(group='solid', name='yield_strength', unit='Pa', &
         & meaning='von Mises stress at which the solid yields, for its ratio to the largest one')
   end subroutine set_stress_rows

   !> Are stresses in depth wanted?
   pure logical function wants_stresses(values)
      !> Values of the rows; shape `(n_stress_rows)`.
      real(dp), intent(in) :: values(:)

      wants_stresses = wants_search(values) .or. has_depth(values)
   end function wants_stresses

   !> Is a search over all depths wanted, by its switch, or by a yield strength without a depth?
   pure logical function wants_search(values)
      !> Values of the rows; shape `(n_stress_rows)`.
      real(dp), intent(in) :: values(:)

      wants_search = is_set(values(stress_input%strength)) .and. .not. has_depth(values)
      if (is_set(values(stress_input%largest))) wants_search = wants_search .or. values(stress_input%largest) > 0
   end function wants_search

   !> Is a depth given?
   pure logical function has_depth(values)
      !> Values of the rows; shape `(n_stress_rows)`.
      real(dp), intent(in) :: values(:)

      has_depth = is_set(values(stress_input%depth))
   end function has_depth

   !> Add to `problems` what the stresses lack or stand beside.
   subroutine check_stresses(rows, values, has_ratio, has_layer, has_adhesion, has_strength, problems)
      !> The rows of `set_stress_rows`; their names are part of the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_stress_rows)`.
      real(dp), intent(in) :: values(:)
      !> Is Poisson's ratio given, is there a layer, adhesion, or a shear stress that does not vanish at the edge of contact?
      logical, intent(in) :: has_ratio, has_layer, has_adhesion, has_strength
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(*), parameter :: unbounded = 'where the stress at the surface has no largest value; give position_z'
      integer :: asked

      if (.not. wants_stresses(values)) return
      asked = merge(stress_input%largest, stress_input%depth, wants_search(values))
      if (has_layer) call add(asked, 'stands beside a layer, in which stresses in depth are not solved')
      if (.not. has_ratio) call problems%add('solid', 'poisson_ratio', 'is missing [-]; the stresses in depth need it')
      if (.not. wants_search(values)) return
      if (has_adhesion) call add(stress_input%largest, 'stands beside &adhesion, whose tension ends at an edge, '//unbounded)
      if (has_strength) call add(stress_input%largest, 'stands beside a shear stress that ends at the edge of contact, '//unbounded)

   contains

      !> Add a problem of one row.
      subroutine add(index, text)
         integer, intent(in) :: index
         character(*), intent(in) :: text

         call problems%add(rows(index)%group, rows(index)%name, text)
      end subroutine add

   end subroutine check_stresses

   !> The results.
   function stress_results() result(r)
      type(result_t) :: r(n_stress_results)

      call set_measure(r(stress_output%von_mises(1):stress_output%von_mises(4)), 'largest_von_mises_stress', 'largest_von_mises', &
         & 'largest von Mises stress in the solid, or at position_z')
      call set_measure(r(stress_output%shear(1):stress_output%shear(4)), 'largest_shear_stress', 'largest_shear', &
         & 'largest shear stress in the solid, or at position_z')
      r(stress_output%search_error) = result_row(name='largest_stress_error', unit='-', &
         & long_name='bound of what the search in depth may have missed of either, over the largest one; what cells leave '// &
         & 'is not in it')
      r(stress_output%yield_ratio) = result_row(name='yield_ratio', unit='-', &
         & long_name='largest von Mises stress over the yield strength; from 1 on the solid is not elastic')
   end function stress_results

   !> The results of one measure.
   subroutine set_measure(r, name, stem, meaning)
      !> Receives the rows; shape `(4)`.
      type(result_t), intent(inout) :: r(:)
      !> Name of the measure, begin of the names of its position, and what it is.
      character(*), intent(in) :: name, stem, meaning

      r(1) = result_row(name=name, unit='Pa', long_name=meaning)
      r(2) = result_row(name=stem//'_depth', unit='m', long_name='its depth')
      r(3) = result_row(name=stem//'_x', unit='m', long_name='its coordinate x')
      r(4) = result_row(name=stem//'_y', unit='m', long_name='its coordinate y')
   end subroutine set_measure

   !> The maps of a depth.
   function stress_profiles() result(p)
      type(profile_t) :: p(n_stress_profiles)
      character(2), parameter :: components(n_stresses) = ['xx', 'yy', 'zz', 'xy', 'xz', 'yz']
      integer :: k

      p(1) = profile_t(name='von_mises_stress_map', unit='Pa', long_name='von Mises stress at position_z')
      p(2) = profile_t(name='largest_shear_stress_map', unit='Pa', long_name='largest shear stress at position_z')
      do k = 1, n_stresses
         p(2 + k) = profile_t(name='stress_'//components(k)//'_map', unit='Pa', &
            & long_name='stress s_'//components(k)//' at position_z, tension positive')
      end do
   end function stress_profiles

end module adfric_periodic_stress_rows
