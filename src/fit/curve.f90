! SPDX-License-Identifier: GPL-3.0-or-later
!> A measured curve beside its model: residuals in standard errors with their derivatives by the free variables.
module adfric_fit_curve
   use adfric_base_kinds, only: dp
   use adfric_fit_parts, only: has_others
   use adfric_fit_problem, only: data_set_t, free_t, n_nuisances
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   implicit none (type, external)
   private
   public :: fit_curve_t, take_points, abscissas_of, nuisance_slopes

   !> A measured curve. Only points that are used are kept.
   type, abstract :: fit_curve_t
      !> Number of the data set, and of points that are used.
      integer :: data_set = 0, n = 0
      !> Variables of the model that the curve has values of its own for, as positions, and these values; not allocated: none.
      integer, allocatable :: others(:)
      !> See `others`.
      real(dp), allocatable :: at(:)
      !> Does a point have a standard error of the abscissa?
      logical :: is_latent = .false.
      !> The points in the data set; shape `(n)`.
      integer, allocatable :: index(:)
      !> Abscissas and ordinates with their standard errors; where the ordinates' is not known, all have the same one. Shape `(n)`.
      real(dp), allocatable :: x(:), y(:), sigma(:), x_sigma(:)
      !> Is the point one of contact?
      logical, allocatable :: is_contact(:)
      !> Of the last evaluation: the model's ordinates, their abscissas, and residuals (data less model, in standard errors).
      real(dp), allocatable :: fitted(:), foot(:), residual(:)
      !> Of the last evaluation: is the point beyond the fold, is it one of the base line, without load?
      logical, allocatable :: is_beyond(:), is_apart(:)
   contains
      procedure(evaluate_i), deferred :: evaluate
      procedure(find_event_i), deferred :: find_event
      procedure(most_rows_i), deferred :: most_rows
      procedure :: values_of
   end type fit_curve_t

   abstract interface
      !> Residuals, model less data in standard errors, and their derivatives. The first n rows are those of the points, more may follow.
      subroutine evaluate_i(self, values, nuisance, slopes, is_exact, n_rows, r, j, is_valid)
         import :: fit_curve_t, dp
         implicit none (type, external)
         !> The curve, which keeps what helps its next evaluation.
         class(fit_curve_t), intent(inout) :: self
         !> Values of all variables of the model.
         real(dp), intent(in) :: values(:)
         !> Values of the nuisances of the curve.
         real(dp), intent(in) :: nuisance(:)
         !> Derivatives of each free variable by the number that is fitted; shape `(n_free)`.
         real(dp), intent(in) :: slopes(:)
         !> Are the derivatives to be as exact as they can be, whatever it costs?
         logical, intent(in) :: is_exact
         integer, intent(out) :: n_rows
         !> Receives the residuals; shape `(most_rows)`.
         real(dp), intent(inout) :: r(:)
         !> Receives their derivatives; shape `(most_rows, n_free)`.
         real(dp), intent(inout) :: j(:, :)
         !> Has the model a value at all points?
         logical, intent(out) :: is_valid
      end subroutine evaluate_i

      !> What the model says of an event, and its derivatives.
      subroutine find_event_i(self, kind, values, nuisance, slopes, value, gradient, is_valid)
         import :: fit_curve_t, dp
         implicit none (type, external)
         !> The curve, whose nuisances shift the event.
         class(fit_curve_t), intent(inout) :: self
         !> One of `event_...`.
         integer, intent(in) :: kind
         real(dp), intent(in) :: values(:), nuisance(:), slopes(:)
         !> Receives the load [N] or position [m].
         real(dp), intent(out) :: value
         !> Receives its derivatives; shape `(n_free)`.
         real(dp), intent(out) :: gradient(:)
         !> Has the model such an event?
         logical, intent(out) :: is_valid
      end subroutine find_event_i

      !> Most rows that an evaluation gives.
      pure integer function most_rows_i(self)
         import :: fit_curve_t
         implicit none (type, external)
         class(fit_curve_t), intent(in) :: self
      end function most_rows_i
   end interface

contains

   !> Values of all variables of the model on a curve.
   pure function values_of(self, values)
      class(fit_curve_t), intent(in) :: self
      !> Those that all curves have.
      real(dp), intent(in) :: values(:)
      real(dp) :: values_of(size(values))

      values_of = values
      if (allocated(self%others)) values_of(self%others) = self%at
   end function values_of

   !> Take the points of a curve that are used.
   subroutine take_points(self, number, data, points, unit)
      class(fit_curve_t), intent(inout) :: self
      integer, intent(in) :: number
      !> The points of the curve alone.
      type(data_set_t), intent(in) :: data
      !> Their indices in the data set.
      integer, intent(in) :: points(:)
      !> The standard error of all ordinates where none is given.
      real(dp), intent(in) :: unit
      logical :: is_used(size(data%x))
      integer, allocatable :: used(:)
      integer :: i

      do i = 1, size(data%x)
         is_used(i) = ieee_is_finite(data%x(i)) .and. ieee_is_finite(data%y(i))
         if (allocated(data%is_used)) is_used(i) = is_used(i) .and. data%is_used(i)
         if (allocated(data%sigma)) is_used(i) = is_used(i) .and. ieee_is_finite(data%sigma(i))
         if (allocated(data%x_sigma)) is_used(i) = is_used(i) .and. ieee_is_finite(data%x_sigma(i))
      end do
      self%data_set = number
      used = pack([(i, i=1, size(data%x))], is_used)
      self%index = points(used)
      self%n = size(used)
      self%x = data%x(used)
      self%y = data%y(used)
      if (has_others(data) .and. size(points) > 0) then
         self%others = data%others
         self%at = data%at(:, 1)
      end if
      allocate (self%sigma(self%n), source=unit)
      if (allocated(data%sigma)) self%sigma = data%sigma(used)
      allocate (self%x_sigma(self%n), source=0.0_dp)
      if (allocated(data%x_sigma)) self%x_sigma = data%x_sigma(used)
      self%is_latent = any(self%x_sigma > 0)
      allocate (self%is_contact(self%n), source=.true.)
      if (allocated(data%is_contact)) self%is_contact = data%is_contact(used)
      allocate (self%fitted(self%n), self%residual(self%n), source=0.0_dp)
      self%foot = self%x
      allocate (self%is_beyond(self%n), self%is_apart(self%n), source=.false.)
   end subroutine take_points

   !> Abscissas in contact that tell how well the abscissa is resolved: those of the curve, or of its data set where a curve has few.
   pure function abscissas_of(self, whole) result(x)
      class(fit_curve_t), intent(in) :: self
      !> The data set with all its curves.
      type(data_set_t), intent(in) :: whole
      real(dp), allocatable :: x(:)
      logical :: is_used(size(whole%x))

      if (.not. has_others(whole)) then
         x = pack(self%x, self%is_contact)
         return
      end if
      is_used = ieee_is_finite(whole%x)
      if (allocated(whole%is_used)) is_used = is_used .and. whole%is_used
      if (allocated(whole%is_contact)) is_used = is_used .and. whole%is_contact
      x = pack(whole%x, is_used)
   end function abscissas_of

   !> Derivatives of the nuisances of a data set by the numbers that are fitted.
   pure subroutine nuisance_slopes(frees, data_set, slopes, of_nuisance)
      type(free_t), intent(in) :: frees(:)
      integer, intent(in) :: data_set
      real(dp), intent(in) :: slopes(:)
      !> Receives the derivatives; shape `(n_free, n_nuisances)`.
      real(dp), intent(out) :: of_nuisance(:, :)
      integer :: k

      of_nuisance = 0
      do k = 1, size(frees)
         if (frees(k)%data_set /= data_set .or. frees(k)%nuisance < 1 .or. frees(k)%nuisance > n_nuisances) cycle
         of_nuisance(k, frees(k)%nuisance) = slopes(k)
      end do
   end subroutine nuisance_slopes

end module adfric_fit_curve
