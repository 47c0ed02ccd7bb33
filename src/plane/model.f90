! SPDX-License-Identifier: GPL-3.0-or-later
!> What the classical models of the half-space share: profiles along axes that the user sets, and rows of the contact modulus.
module adfric_plane_model
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: count_words, get_word
   use adfric_solid_contact_modulus, only: derive_contact_modulus
   use adfric_describe_model, only: derived_t
   use adfric_describe_pointwise, only: pointwise_model_t
   use adfric_describe_check, only: require
   use adfric_describe_rows, only: set_output_axis, set_coordinate, switch
   use adfric_describe_table, only: variable_t, result_t, profile_t, profile_axis_t
   implicit none (type, external)
   private
   public :: halfspace_model_t

   !> Samples along the last axis of the profiles; along the first of two there is one.
   integer, parameter :: n_samples = 201

   !> What the classical models share: profiles on axes whose ends and samples the input gives.
   type, abstract, extends(pointwise_model_t) :: halfspace_model_t
      !> Index of the switch of the profiles; begin, end and number of each axis follow.
      integer :: output = 0
      !> First and last index of the rows of the contact modulus; (0, -1) if there are none.
      integer :: solids(2) = [0, -1]
   contains
      procedure :: set_tables
      procedure :: check_values
      procedure :: derive_quantities
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure(check_case_i), deferred :: check_case
   end type halfspace_model_t

   abstract interface

      !> Add to `problems` what is missing or impossible; the axes of the profiles are checked elsewhere.
      subroutine check_case_i(self, values, problems)
         import :: halfspace_model_t, dp, problems_t
         implicit none (type, external)
         !> The model; its tables give the variables their names.
         class(halfspace_model_t), intent(in) :: self
         !> Values of the variables, in the order of the table; shape `(n_variables)`.
         real(dp), intent(in) :: values(:)
         !> Receives what is wrong with the input; nothing is removed.
         type(problems_t), intent(inout) :: problems
      end subroutine check_case_i

   end interface

contains

   !> Set the tables of the model; rows of the profiles' axes are added to its variables.
   subroutine set_tables(self, name, summary, variables, results, profiles, axes, is_depth)
      class(halfspace_model_t), intent(inout) :: self
      !> Name of the model in `&job model = ...`.
      character(*), intent(in) :: name
      !> What the model is, in one line for `adfric help`.
      character(*), intent(in) :: summary
      !> Variables of the model; those of the profiles' axes follow them in its table.
      type(variable_t), intent(in) :: variables(:)
      type(result_t), intent(in) :: results(:)
      type(profile_t), intent(in) :: profiles(:)
      !> Names of the profiles' axes, the slowest first, separated by a blank.
      character(*), intent(in) :: axes
      !> Does the first axis point into the solid?
      logical, intent(in) :: is_depth
      integer :: k, n

      self%name = name
      self%summary = summary
      self%references = 'K. L. Johnson, Contact Mechanics, Cambridge University Press (1985)'
      n = size(variables)
      self%output = n + 1
      allocate (self%variables(n + 1 + 3*count_words(axes)))
      self%variables(:n) = variables
      self%variables(n + 1) = switch(group='output', name='profiles', meaning='write profiles of every point', default=.false.)
      do k = 1, count_words(axes)
         call set_output_axis(get_word(axes, k), merge(1, n_samples, k < count_words(axes)), is_depth .and. k == 1, &
            & self%variables(n + 3*k - 1:n + 3*k + 1))
      end do
      self%results = results
      self%profiles = profiles
      allocate (self%counts(0))
      self%profile_axes = axes
   end subroutine set_tables

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(halfspace_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems
      integer :: k, at

      call self%check_case(values, problems)
      if (.not. self%wants_profiles(values)) return
      do at = self%output + 1, size(self%variables)
         if (is_swept(at)) call problems%add('output', self%variables(at)%name, &
            & 'is swept, but all profiles share their axes; sweep another variable')
      end do
      do k = 1, count_words(self%profile_axes)
         at = self%output + 3*k - 2
         if (nint(values(at + 2)) == 1) cycle
         call require(self%variables, values, [at + 1], problems)
         if (is_set(values(at + 1)) .and. .not. values(at + 1) > values(at)) call problems%add('output', &
            & self%variables(at + 1)%name, 'is not larger than '//self%variables(at)%name)
      end do
   end subroutine check_values

   !> See `model_t`.
   function derive_quantities(self, values) result(list)
      class(halfspace_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: list(:)

      if (self%solids(1) > 0) then
         associate (first => self%solids(1), last => self%solids(2))
            list = derive_contact_modulus(self%variables(first:last), values(first:last))
         end associate
      else
         allocate (list(0))
      end if
   end function derive_quantities

   !> See `model_t`.
   pure logical function wants_profiles(self, values)
      !> The model, for the index of its switch of the profiles.
      class(halfspace_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      wants_profiles = values(self%output) > 0
   end function wants_profiles

   !> See `model_t`.
   subroutine get_profile_axes(self, values, axes)
      !> The model, for the names and indices of its axes.
      class(halfspace_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Receives the axes, the slowest first.
      type(profile_axis_t), allocatable, intent(out) :: axes(:)
      integer :: k, at

      allocate (axes(count_words(self%profile_axes)))
      do k = 1, size(axes)
         at = self%output + 3*k - 2
         call set_coordinate(axes(k), self%profile_axes, k, even_steps(values(at:at + 2)))
      end do
   end subroutine get_profile_axes

   !> Coordinates in even steps; all the same where the end is not given.
   pure function even_steps(values) result(coordinates)
      !> Beginning [m], end [m] and number of the coordinates.
      real(dp), intent(in) :: values(3)
      real(dp), allocatable :: coordinates(:)
      integer :: n, k

      n = nint(values(3))
      allocate (coordinates(n), source=values(1))
      if (n == 1 .or. .not. is_set(values(2))) return
      coordinates = [((values(1)*(n - 1 - k) + values(2)*k)/(n - 1), k=0, n - 1)]
   end function even_steps

end module adfric_plane_model
