! SPDX-License-Identifier: GPL-3.0-or-later
!> A relaxation spectrum fitted to a master curve: storage and loss modulus over the frequency.
!>
!> Relaxation times are spaced evenly on a logarithmic scale, from a decade below 1/omega_max to a decade above 1/omega_min. The moduli
!> are the non-negative least squares of
!> $$ \sum_\omega \left|\frac{M(i \omega) - E}{E}\right|^2, \qquad E = E' + i E'', $$
!> with the relaxed modulus among the unknowns, unless it is prescribed. The weight 1/|E| lets the rubber count as much as the glass. Arms that the data do
!> not ask for have the modulus 0 and are left out.
module adfric_solid_master_curve
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_solid_prony, only: prony_t, new_prony, most_arms
   use adfric_numerics_non_negative, only: solve_non_negative
   implicit none (type, external)
   private
   public :: master_curve_fit_t, misfit_t, fit_master_curve, default_terms_per_decade

   !> Relaxation times in a decade that fit a smooth curve to half a percent.
   real(dp), parameter :: default_terms_per_decade = 1.5_dp
   !> A relaxed modulus that is less than this share of every |E| is round-off.
   real(dp), parameter :: least_share = 1.0e-10_dp

   !> How far a fit is off, in relative terms.
   type :: misfit_t
      !> Largest misfit of all frequencies [-].
      real(dp) :: largest = 0
      !> Root mean square of all frequencies [-].
      real(dp) :: rms = 0
   end type misfit_t

   !> A fitted spectrum, and what is known of it.
   type :: master_curve_fit_t
      !> The spectrum [unit of the moduli, s over rad]; of a fluid, `relaxed` is 0.
      type(prony_t) :: prony
      !> Is the spectrum proved to be the best of its times?
      logical :: is_solved = .false.
      !> Do the data ask for a relaxed modulus? Without one the fit is a fluid.
      logical :: is_solid = .false.
      !> Number of times that were offered to the fit, of which those with a modulus are in the spectrum.
      integer :: n_times = 0
      !> Range of the data: angular frequencies [rad/s].
      real(dp) :: lowest_frequency = 0, highest_frequency = 0
      !> Misfit of E, |M - E|/|E|.
      type(misfit_t) :: modulus
      !> Misfit of the storage modulus, over itself, where it is positive.
      type(misfit_t) :: storage
      !> Misfit of the loss modulus, over itself, where it is positive.
      type(misfit_t) :: loss
   end type master_curve_fit_t

contains

   !> Fit a relaxation spectrum to a master curve.
   pure subroutine fit_master_curve(self, frequencies, storage, loss, terms_per_decade, relaxed)
      type(master_curve_fit_t), intent(out) :: self
      !> Angular frequencies of the data, in any order [rad/s], > 0; shape `(n)`, n > 0.
      real(dp), intent(in) :: frequencies(:)
      !> Storage modulus E' [any unit of a modulus]; shape `(n)`.
      real(dp), intent(in) :: storage(:)
      !> Loss modulus E'' [unit of E'], not 0 where E' is; shape `(n)`.
      real(dp), intent(in) :: loss(:)
      !> Relaxation times in a decade [-], > 0. There are not more than `most_arms` in all.
      real(dp), intent(in) :: terms_per_decade
      !> Relaxed modulus [unit of E'], > 0; it is found if it is not present.
      real(dp), intent(in), optional :: relaxed
      real(dp), allocatable :: times(:), moduli(:)

      if (has_asserts) call assert(size(storage) == size(frequencies) .and. size(loss) == size(frequencies), &
         & 'fit_master_curve: shapes')
      if (has_asserts) call assert(size(frequencies) > 0 .and. all(frequencies > 0) .and. all(abs(storage) + abs(loss) > 0) &
         & .and. terms_per_decade > 0, 'fit_master_curve: frequencies > 0, moduli that are not 0, terms_per_decade > 0')
      self%lowest_frequency = minval(frequencies)
      self%highest_frequency = maxval(frequencies)
      call get_times(self%lowest_frequency, self%highest_frequency, terms_per_decade, times)
      self%n_times = size(times)
      allocate (moduli(0:size(times)))
      call fit_moduli(frequencies, storage, loss, times, moduli, self%is_solved, relaxed)
      self%is_solid = moduli(0) > least_share*minval(hypot(storage, loss)) .or. present(relaxed)
      if (.not. self%is_solid) moduli(0) = 0
      call new_prony(self%prony, moduli(0), moduli(1:), times)
      call set_misfits(self, frequencies, storage, loss)
   end subroutine fit_master_curve

   !> Relaxation times for a range of frequencies.
   pure subroutine get_times(lowest, highest, terms_per_decade, times)
      !> Ends of the range of angular frequencies [rad/s].
      real(dp), intent(in) :: lowest, highest
      !> Times in a decade.
      real(dp), intent(in) :: terms_per_decade
      !> The times [s], rising.
      real(dp), allocatable, intent(out) :: times(:)
      real(dp) :: first, decades
      integer :: i, n

      ! one decade beyond each end of the range
      first = -log10(highest) - 1
      decades = log10(highest) - log10(lowest) + 2
      n = 1 + nint(min(max(terms_per_decade*decades, 1.0_dp), most_arms - 1.0_dp))
      allocate (times(n))
      do i = 1, n
         times(i) = 10.0_dp**(first + decades*(i - 1)/(n - 1))
      end do
   end subroutine get_times

   !> The moduli of given times.
   pure subroutine fit_moduli(frequencies, storage, loss, times, moduli, is_solved, relaxed)
      !> Angular frequencies of the data [rad/s]; shape `(n)`.
      real(dp), intent(in) :: frequencies(:)
      !> Storage modulus; shape `(n)`.
      real(dp), intent(in) :: storage(:)
      !> Loss modulus; shape `(n)`.
      real(dp), intent(in) :: loss(:)
      !> Relaxation times [s]; shape `(n_times)`.
      real(dp), intent(in) :: times(:)
      !> The relaxed modulus and those of the times; shape `(0:n_times)`.
      real(dp), intent(out) :: moduli(0:)
      !> Are they proved to be the best?
      logical, intent(out) :: is_solved
      !> Relaxed modulus; it is found if it is not present.
      real(dp), intent(in), optional :: relaxed
      real(dp) :: columns(2*size(frequencies), 0:size(times)), weights(size(frequencies))
      type(prony_t) :: arm
      integer :: i, n

      n = size(frequencies)
      weights = 1/hypot(storage, loss)
      columns(:n, 0) = weights
      columns(n + 1:, 0) = 0
      do i = 1, size(times)
         call new_prony(arm, 0.0_dp, [1.0_dp], times(i:i))
         call arm%get_complex_modulus(frequencies, columns(:n, i), columns(n + 1:, i))
         columns(:n, i) = columns(:n, i)*weights
         columns(n + 1:, i) = columns(n + 1:, i)*weights
      end do
      if (present(relaxed)) then
         moduli(0) = relaxed
         call solve_non_negative(columns(:, 1:), [(storage - relaxed)*weights, loss*weights], moduli(1:), is_solved)
      else
         call solve_non_negative(columns, [storage*weights, loss*weights], moduli, is_solved)
      end if
   end subroutine fit_moduli

   !> How far the fit is off.
   pure subroutine set_misfits(self, frequencies, storage, loss)
      type(master_curve_fit_t), intent(inout) :: self
      !> Angular frequencies of the data [rad/s]; shape `(n)`.
      real(dp), intent(in) :: frequencies(:)
      !> Storage modulus; shape `(n)`.
      real(dp), intent(in) :: storage(:)
      !> Loss modulus; shape `(n)`.
      real(dp), intent(in) :: loss(:)
      real(dp), dimension(size(frequencies)) :: fitted_storage, fitted_loss

      call self%prony%get_complex_modulus(frequencies, fitted_storage, fitted_loss)
      call set_misfit(self%modulus, hypot(fitted_storage - storage, fitted_loss - loss), hypot(storage, loss))
      call set_misfit(self%storage, abs(fitted_storage - storage), storage)
      call set_misfit(self%loss, abs(fitted_loss - loss), loss)
   end subroutine set_misfits

   !> Largest value and root mean square of relative misfits, where there is something that they are relative to.
   pure subroutine set_misfit(self, misfits, values)
      !> Receives the two numbers; 0 if no value is positive.
      type(misfit_t), intent(out) :: self
      !> Misfits, >= 0; shape `(n)`.
      real(dp), intent(in) :: misfits(:)
      !> What they are relative to; shape `(n)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: shares(size(values))
      integer :: n

      n = count(values > 0)
      if (n == 0) return
      shares(:n) = pack(misfits, values > 0)/pack(values, values > 0)
      self%largest = maxval(shares(:n))
      self%rms = norm2(shares(:n))/sqrt(real(n, dp))
   end subroutine set_misfit

end module adfric_solid_master_curve
