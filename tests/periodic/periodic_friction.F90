! Friction from pressure and from loss on maps of any shape, against sums over waves that are found one by one.
module periodic_friction
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_material_prony, only: prony_t, new_prony
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_friction, only: friction_t, get_friction, get_losses
   use adfric_periodic_operator, only: periodic_operator_t, new_periodic_operator
   use adfric_periodic_sliding_kernel, only: sliding_kernel_t, new_sliding_kernel
   use trial_surfaces, only: noise_surface
   use funit
   implicit none (type, external)

   real(dp), parameter :: two_pi = 6.283185307179586476925286766559_dp, period(2) = [1.0_dp, 0.7_dp]
   !> Sums of some 60 terms of order 1 to 10.
   real(dp), parameter :: round_off = 1.0e-11_dp

contains

   !> A body on two arms, along x or y.
   subroutine new_kernel(kernel, along, is_backward)
      type(sliding_kernel_t), intent(out) :: kernel
      integer, intent(in) :: along
      logical, intent(in) :: is_backward
      type(prony_t) :: prony
      integer :: steps(2)

      call new_prony(prony, 1.0_dp, [4.0_dp, 2.0_dp], [0.1_dp, 1.5_dp])
      steps = 0
      steps(along) = merge(-1, 1, is_backward)
      call new_sliding_kernel(kernel, elastic_kernel_t(), prony, 0.3_dp, steps)
   end subroutine new_kernel

   !> A map of random numbers.
   function random_map(n, seed) result(map)
      integer, intent(in) :: n(2), seed
      real(dp) :: map(n(1), n(2))
      real(dp), allocatable :: noise(:, :)

      noise = noise_surface(maxval(n), seed)
      map = 100*noise(:n(1), :n(2))
   end function random_map

   !> Amplitude of a wave of a map.
   complex(dp) function amplitude_of(map, k, l) result(amplitude)
      real(dp), intent(in) :: map(:, :)
      integer, intent(in) :: k, l
      integer :: i, j

      amplitude = 0
      do j = 1, size(map, 2)
         do i = 1, size(map, 1)
            amplitude = amplitude + map(i, j)*exp(cmplx(0, -two_pi*(real(k*i, dp)/size(map, 1) + real(l*j, dp)/size(map, 2)), dp))
         end do
      end do
      amplitude = amplitude/size(map)
   end function amplitude_of

   !> Sum over all waves of -conj(p) i k u, which is -mean(p du/dx); waves of two cells count nothing.
   function slope_product(p, u) result(product)
      real(dp), intent(in) :: p(:, :), u(:, :)
      real(dp) :: product(2)
      integer :: k, l, n(2)

      n = shape(u)
      product = 0
      do l = -(n(2) - 1)/2, n(2)/2
         do k = -(n(1) - 1)/2, n(1)/2
            associate (term => -real(conjg(amplitude_of(p, k, l))*(0.0_dp, 1.0_dp)*amplitude_of(u, k, l), dp))
               if (2*k /= n(1)) product(1) = product(1) + two_pi*k/period(1)*term
               if (2*l /= n(2)) product(2) = product(2) + two_pi*l/period(2)*term
            end associate
         end do
      end do
   end function slope_product

   !> Sum over all waves of k (-Im A) |u|^2.
   function loss_of(kernel, u) result(loss)
      type(sliding_kernel_t), intent(in) :: kernel
      real(dp), intent(in) :: u(:, :)
      real(dp) :: loss(2)
      complex(dp) :: stiffness(1, 1)
      integer :: k, l, n(2)

      n = shape(u)
      loss = 0
      do l = -(n(2) - 1)/2, n(2)/2
         do k = -(n(1) - 1)/2, n(1)/2
            call kernel%get_stiffness([k/period(1)], [l/period(2)], period/n, stiffness)
            associate (term => -aimag(stiffness(1, 1))*abs(amplitude_of(u, k, l))**2)
               if (2*k /= n(1)) loss(1) = loss(1) + two_pi*k/period(1)*term
               if (2*l /= n(2)) loss(2) = loss(2) + two_pi*l/period(2)*term
            end associate
         end do
      end do
   end function loss_of

   ! Odd and even numbers of cells, all four directions: both forms wave by wave, and the loss is what the pressure does on the
   ! slopes of the displacement.
   !@test
   subroutine test_waves()
      integer, parameter :: shapes(2, 4) = reshape([9, 7, 8, 6, 7, 8, 10, 9], [2, 4])
      type(sliding_kernel_t) :: kernel
      type(periodic_operator_t) :: operator
      type(friction_t) :: friction
      type(error_t), allocatable :: error
      real(dp), allocatable :: height(:, :), gap(:, :), pressure(:, :), stress(:, :)
      integer :: m, along, k
      real(dp) :: forward

      do m = 1, size(shapes, 2)
         height = random_map(shapes(:, m), 3*m)
         gap = random_map(shapes(:, m), 3*m + 1)
         pressure = random_map(shapes(:, m), 3*m + 2)
         allocate (stress, mold=pressure)
         do k = 1, 4
            along = 1 + modulo(k, 2)
            call new_kernel(kernel, along, k > 2)
            call new_periodic_operator(operator, kernel, shapes(:, m), period, .false., .false., error)
#line 120 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
  call assertFalse(allocated(error), &
 & location=SourceLocation( &
 & 'periodic_friction.pf', &
 & 120) )
  if (anyExceptions()) return
#line 121 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
            ! the gap of the undeformed surfaces is a constant less the heights
            call get_friction(operator, pressure, 3 - height, gap, friction)
#line 123 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
  call assertEqual(slope_product(pressure, height), friction%direct, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_friction.pf', &
 & 123) )
  if (anyExceptions()) return
#line 124 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
#line 124 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
  call assertEqual(loss_of(kernel, gap + height), friction%loss, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_friction.pf', &
 & 124) )
  if (anyExceptions()) return
#line 125 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
            call operator%apply_stiffness(gap + height, stress)
#line 126 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
  call assertEqual(slope_product(stress, gap + height), friction%loss, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_friction.pf', &
 & 126) )
  if (anyExceptions()) return
#line 127 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
            forward = merge(-1, 1, k > 2)*friction%loss(along)
#line 128 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
  call assertGreaterThan(forward, 0.1_dp, &
 & location=SourceLocation( &
 & 'periodic_friction.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
         end do
         deallocate (stress)
      end do
   end subroutine test_waves

   ! A line of cells has friction along x alone; a solid at rest has none.
   !@test
   subroutine test_line_and_rest()
      type(sliding_kernel_t) :: kernel
      type(periodic_operator_t) :: operator
      type(friction_t) :: friction
      type(error_t), allocatable :: error
      real(dp) :: u(9, 1), loss(2)

      u = random_map([9, 1], 5)
      call new_kernel(kernel, 1, .false.)
      call new_periodic_operator(operator, kernel, [9, 1], period, .false., .false., error)
      call get_losses(operator, u, loss)
#line 147 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
  call assertEqual(loss_of(kernel, u), loss, tolerance=round_off, &
 & location=SourceLocation( &
 & 'periodic_friction.pf', &
 & 147) )
  if (anyExceptions()) return
#line 148 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
#line 148 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
  call assertEqual(0.0_dp, loss(2), &
 & location=SourceLocation( &
 & 'periodic_friction.pf', &
 & 148) )
  if (anyExceptions()) return
#line 149 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
      call new_periodic_operator(operator, elastic_kernel_t(), [9, 1], period, .false., .false., error)
      call get_friction(operator, 1 + u, 2 - u, u, friction)
#line 151 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
  call assertEqual(0.0_dp, maxval(abs([friction%direct, friction%loss])), &
 & location=SourceLocation( &
 & 'periodic_friction.pf', &
 & 151) )
  if (anyExceptions()) return
#line 152 "/work/wt/penetration/tests/periodic/periodic_friction.pf"
   end subroutine test_line_and_rest

end module periodic_friction

module Wrapperiodic_friction
   use FUnit
   use periodic_friction
   implicit none
   private

contains


end module Wrapperiodic_friction

function periodic_friction_suite() result(suite)
   use FUnit
   use periodic_friction
   use Wrapperiodic_friction
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_friction_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_waves', &
      test_waves))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_line_and_rest', &
      test_line_and_rest))
   call suite%addTest(t)


end function periodic_friction_suite

