! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of time on panels: polynomials by their values at Chebyshev's points of the second kind, from s = -1 at the begin of a
!> panel to s = 1 at its end.
!>
!> Memory that fades is integrated exactly, however long the panel is for it. With lambda = half the panel over the relaxation time,
!> $$ I_k(x) = \int_{-1}^{x} e^{-\lambda (x - s)} T_k(s)\, ds, \qquad
!>    2 I_k = \frac{B_{k+1} - \lambda I_{k+1}}{k + 1} - \frac{B_{k-1} - \lambda I_{k-1}}{k - 1}, $$
!> with \( B_k = T_k(x) - e^{-\lambda (x + 1)} T_k(-1) \), since \( 2 T_k = T'_{k+1}/(k + 1) - T'_{k-1}/(k - 1) \). For a small lambda
!> the recurrence is solved as a system of equations from a distant end, where I_k is known well enough (F. W. J. Olver's method);
!> its pivots are above 1, for its matrix is 1 plus one that is skew after scaling. For a large lambda it is stable upwards.
module adfric_numerics_time_panels
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   implicit none (type, external)
   private
   public :: n_nodes, panel_nodes, panel_slopes, panel_sums, get_memory, get_faded, get_all_faded, get_tail, find_fall
   public :: last_begun, lost_part, lost_twice, get_weights, get_weights_from_end

   !> Number of nodes of a panel.
   integer, parameter :: n_nodes = 12
   !> Degree of the polynomials.
   integer, parameter :: degree = n_nodes - 1
   integer :: i_, j_, k_
   !> The nodes, upwards.
   real(dp), parameter :: panel_nodes(n_nodes) = [(sin(pi*(2*j_ - n_nodes - 1)/(2*degree)), j_=1, n_nodes)]
   !> The nodes, from the end: 1 less than they are, to all digits near it.
   real(dp), parameter :: nodes_from_end(n_nodes) = [(-2*sin(pi*(n_nodes - j_)/(2*degree))**2, j_=1, n_nodes)]
   !> Lambda above which the recurrence goes upwards, and the order where the system begins for those below.
   real(dp), parameter :: largest_by_system = 24
   integer, parameter :: distant = 54
   !> T_k at the nodes; shape `(n_nodes, 0:distant)`.
   real(dp), parameter :: values_of_t(n_nodes, 0:distant) = reshape([((cos(pi*modulo(k_*(n_nodes - j_), 2*degree)/degree), &
      & j_=1, n_nodes), k_=0, distant)], [n_nodes, distant + 1])
   !> (T_{k+1}/(k + 1) - T_{k-1}/(k - 1))/2 at the nodes; shape `(n_nodes, 2:distant - 1)`.
   real(dp), parameter :: steps_of_t(n_nodes, 2:distant - 1) = reshape([(((values_of_t(j_, k_ + 1)/(k_ + 1) &
      & - values_of_t(j_, k_ - 1)/(k_ - 1))/2, j_=1, n_nodes), k_=2, distant - 1)], [n_nodes, distant - 2])
   !> Coefficients of T_k of a polynomial from its values; shape `(0:degree, n_nodes)`.
   real(dp), parameter :: to_coefficients(0:degree, n_nodes) = reshape([((2*values_of_t(j_, k_)/degree &
      & *merge(0.5_dp, 1.0_dp, j_ == 1 .or. j_ == n_nodes)*merge(0.5_dp, 1.0_dp, k_ == 0 .or. k_ == degree), k_=0, degree), &
      & j_=1, n_nodes)], [n_nodes, n_nodes])
   !> Signs and sizes of the weights of interpolation.
   real(dp), parameter :: barycentric(n_nodes) = [((-1)**j_*merge(0.5_dp, 1.0_dp, j_ == 1 .or. j_ == n_nodes), j_=1, n_nodes)]
   !> Derivatives by s at the nodes, off the diagonal; shape `(n_nodes, n_nodes)`.
   real(dp), parameter :: off_diagonal(n_nodes, n_nodes) = reshape([((merge(0.0_dp, barycentric(j_)/barycentric(i_) &
      & /(panel_nodes(i_) - panel_nodes(j_) + merge(1, 0, i_ == j_)), i_ == j_), i_=1, n_nodes), j_=1, n_nodes)], &
      & [n_nodes, n_nodes])
   !> The derivatives; the derivative of a constant is 0 to round-off.
   real(dp), parameter :: panel_slopes(n_nodes, n_nodes) = reshape([((merge(-sum(off_diagonal(i_, :)), off_diagonal(i_, j_), &
      & i_ == j_), i_=1, n_nodes), j_=1, n_nodes)], [n_nodes, n_nodes])
   !> Weights of the integral over s from -1 to 1 (C. W. Clenshaw and A. R. Curtis).
   real(dp), parameter :: panel_sums(n_nodes) = 2*abs(barycentric)/degree*(1 - 2*(values_of_t(:, 2)/3 + values_of_t(:, 4)/15 &
      & + values_of_t(:, 6)/35 + values_of_t(:, 8)/63 + values_of_t(:, 10)/99))

contains

   !> The matrix that turns values of f at the nodes into its integrals with memory, int exp(-lambda (x - s)) f(s) ds from -1 to each
   !> node x.
   pure subroutine get_memory(lambda, memory)
      !> Half the length of the panel over the relaxation time, >= 0.
      real(dp), intent(in) :: lambda
      !> Receives the matrix; shape `(n_nodes, n_nodes)`, nodes x first.
      real(dp), intent(out) :: memory(n_nodes, n_nodes)
      real(dp) :: integrals(n_nodes, 0:degree), faded(n_nodes), row(n_nodes)
      integer :: k

      call get_integrals(lambda, faded, integrals)
      memory = 0
      do k = 0, degree
         row = to_coefficients(k, :)
         call add_product(integrals(:, k), row, memory)
      end do
   end subroutine get_memory

   !> The integrals with memory of one function, for less than its matrix costs; and exp(-lambda (x + 1)) at the nodes.
   pure subroutine get_faded(lambda, values, integral, faded)
      !> Half the length of the panel over the relaxation time, >= 0.
      real(dp), intent(in) :: lambda
      !> Values of the function at the nodes.
      real(dp), intent(in) :: values(n_nodes)
      !> Receive the integrals up to the nodes, and what has faded by then.
      real(dp), intent(out) :: integral(n_nodes), faded(n_nodes)
      real(dp) :: integrals(n_nodes, 0:degree)

      call get_integrals(lambda, faded, integrals)
      integral = matmul(integrals, matmul(to_coefficients, values))
   end subroutine get_faded

   !> The same of several functions at once.
   pure subroutine get_all_faded(lambda, values, integrals, faded)
      !> Half the length of the panel over the relaxation time, >= 0.
      real(dp), intent(in) :: lambda
      !> Values of the functions at the nodes; shape `(n_nodes, n_functions)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives the integrals up to the nodes; shape `(n_nodes, n_functions)`.
      real(dp), intent(out) :: integrals(:, :)
      !> Receives what has faded by then.
      real(dp), intent(out) :: faded(n_nodes)
      real(dp) :: of_t(n_nodes, 0:degree)

      call get_integrals(lambda, faded, of_t)
      integrals = matmul(of_t, matmul(to_coefficients, values))
   end subroutine get_all_faded

   !> The integrals of T_k with memory.
   pure subroutine get_integrals(lambda, faded, integrals)
      real(dp), intent(in) :: lambda
      !> Receives exp(-lambda (x + 1)) at the nodes x.
      real(dp), intent(out) :: faded(n_nodes)
      real(dp), intent(out) :: integrals(n_nodes, 0:degree)

      faded = exp(-lambda*(panel_nodes + 1))
      if (lambda > largest_by_system) then
         call sum_upwards(lambda, faded, integrals)
      else
         call solve_system(lambda, faded, integrals)
      end if
   end subroutine get_integrals

   !> Add the product of a column and a row.
   pure subroutine add_product(column, row, matrix)
      real(dp), intent(in) :: column(n_nodes), row(n_nodes)
      real(dp), intent(inout) :: matrix(n_nodes, n_nodes)
      integer :: j

      do j = 1, n_nodes
         matrix(:, j) = matrix(:, j) + column*row(j)
      end do
   end subroutine add_product

   !> T_k at the nodes less what of its value at -1 has not faded.
   pure function end_terms(k, faded) result(terms)
      integer, intent(in) :: k
      !> exp(-lambda (x + 1)) at the nodes x.
      real(dp), intent(in) :: faded(n_nodes)
      real(dp) :: terms(n_nodes)

      terms = values_of_t(:, k) - merge(1, -1, modulo(k, 2) == 0)*faded
   end function end_terms

   !> The integrals of T_k with memory, for a large lambda.
   pure subroutine sum_upwards(lambda, faded, integrals)
      real(dp), intent(in) :: lambda, faded(n_nodes)
      real(dp), intent(out) :: integrals(n_nodes, 0:degree)
      integer :: k

      integrals(:, 0) = (1 - faded)/lambda
      integrals(:, 1) = (end_terms(1, faded) - integrals(:, 0))/lambda
      integrals(:, 2) = (end_terms(2, faded) - 4*integrals(:, 1))/lambda
      do k = 2, degree - 1
         integrals(:, k + 1) = (end_terms(k + 1, faded) - (k + 1)*((end_terms(k - 1, faded) - lambda*integrals(:, k - 1))/(k - 1) &
            & + 2*integrals(:, k)))/lambda
      end do
   end subroutine sum_upwards

   !> The integrals of T_k with memory, for a small lambda. At k = `far` - 1 what lambda adds is left out: down to `degree` this error
   !> is divided by more than 10^16.
   pure subroutine solve_system(lambda, faded, integrals)
      real(dp), intent(in) :: lambda, faded(n_nodes)
      real(dp), intent(out) :: integrals(n_nodes, 0:degree)
      real(dp) :: right(n_nodes, distant - 1), pivot(distant - 1), ratio
      integer :: k, far

      far = distant
      if (lambda < 6) far = 38
      if (lambda < 1) far = 26
      right(:, 1) = end_terms(2, faded)/4
      do k = 2, far - 1
         ! the values at -1 of both are the same
         right(:, k) = steps_of_t(:, k) + merge(-1, 1, modulo(k, 2) == 0)/(k**2 - 1.0_dp)*faded
      end do
      pivot(1) = 1
      do k = 2, far - 1
         ! the row of k has -lambda/(2(k - 1)), 1 and lambda/(2(k + 1))
         ratio = lambda/(2*(k - 1)*pivot(k - 1))
         pivot(k) = 1 + ratio*merge(lambda/4, lambda/(2*k), k == 2)
         right(:, k) = right(:, k) + ratio*right(:, k - 1)
      end do
      right(:, far - 1) = right(:, far - 1)/pivot(far - 1)
      do k = far - 2, 1, -1
         right(:, k) = (right(:, k) - merge(lambda/4, lambda/(2*(k + 1)), k == 1)*right(:, k + 1))/pivot(k)
      end do
      if (lambda > 0.1_dp) then
         integrals(:, 0) = (1 - faded)/lambda
      else
         integrals(:, 0) = small_decay(lambda*(panel_nodes + 1))*(panel_nodes + 1)
      end if
      integrals(:, 1:) = right(:, :degree)
   end subroutine solve_system

   !> (1 - exp(-x))/x of a small x.
   elemental real(dp) function small_decay(x)
      real(dp), intent(in) :: x
      integer :: k

      small_decay = 1
      do k = 14, 2, -1
         small_decay = 1 - x*small_decay/k
      end do
   end function small_decay

   !> 1 - exp(-x) to all digits, of any x >= 0.
   elemental real(dp) function lost_part(x)
      !> Time over a relaxation time.
      real(dp), intent(in) :: x

      if (x > 1) then
         lost_part = 1 - exp(-x)
      else
         lost_part = 2*exp(-x/2)*sinh(x/2)
      end if
   end function lost_part

   !> 1 - (1 + x) exp(-x), the integral of s exp(-s) from 0, to all digits, of any x >= 0.
   elemental real(dp) function lost_twice(x)
      !> Time over a relaxation time.
      real(dp), intent(in) :: x
      integer, parameter :: most = 14
      integer :: k

      if (x > 0.5_dp) then
         lost_twice = 1 - exp(-x) - x*exp(-x)
      else
         ! sum of (-1)^k x^k/(k! (k + 2)), times x^2
         lost_twice = 1.0_dp/(most + 2)
         do k = most - 1, 0, -1
            lost_twice = 1.0_dp/(k + 2) - lost_twice*x/(k + 1)
         end do
         lost_twice = lost_twice*x**2
      end if
   end function lost_twice

   !> Weights w of the values at the nodes for a position: f(s) = sum w f (J.-P. Berrut and L. N. Trefethen, SIAM Rev. 46, 2004, 501).
   pure subroutine get_weights(s, weights)
      !> Position, from -1 to 1; a little beyond it continues the polynomial.
      real(dp), intent(in) :: s
      !> Receives the weights; shape `(n_nodes)`.
      real(dp), intent(out) :: weights(n_nodes)

      call set_weights(s - panel_nodes, weights)
   end subroutine get_weights

   !> The same for a position that is known by its distance from the end, to all digits of this distance.
   pure subroutine get_weights_from_end(x, weights)
      !> Position less 1, from -2 to 0; a little beyond it continues the polynomial.
      real(dp), intent(in) :: x
      !> Receives the weights; shape `(n_nodes)`.
      real(dp), intent(out) :: weights(n_nodes)

      call set_weights(x - nodes_from_end, weights)
   end subroutine get_weights_from_end

   !> Weights by the distances from the nodes.
   pure subroutine set_weights(distances, weights)
      !> Position less that of each node.
      real(dp), intent(in) :: distances(n_nodes)
      real(dp), intent(out) :: weights(n_nodes)
      integer :: j

      do j = 1, n_nodes
         if (abs(distances(j)) > 0) cycle
         weights = 0
         weights(j) = 1
         return
      end do
      weights = barycentric/distances
      weights = weights/sum(weights)
   end subroutine set_weights

   !> Size of what a polynomial may lack: the larger one of its last two coefficients.
   pure real(dp) function get_tail(values) result(tail)
      !> Its values at the nodes.
      real(dp), intent(in) :: values(n_nodes)

      tail = maxval(abs(matmul(to_coefficients(degree - 1:, :), values)))
   end function get_tail

   !> Where a polynomial that begins above 0 falls below it: the last root before it is below -`small` for the first time; -1, if it
   !> was never above 0, and 2, if it does not fall so far. It is looked at in `n_looks` points.
   pure real(dp) function find_fall(values, small) result(root)
      !> Values at the nodes.
      real(dp), intent(in) :: values(n_nodes)
      !> What is round-off, >= 0.
      real(dp), intent(in) :: small
      integer, parameter :: n_looks = 3*n_nodes, most_halvings = 60
      real(dp) :: low, high, middle, at_low, at_high
      integer :: k

      root = 2
      low = -1
      at_low = max(values(1), 0.0_dp)
      do k = 1, n_looks
         high = 1
         if (k < n_looks) high = -cos(pi*k/n_looks)
         at_high = value_at(high)
         if (at_high < -small) exit
         if (.not. at_high >= 0) cycle
         low = high
         at_low = at_high
      end do
      if (k > n_looks) return
      do k = 1, most_halvings
         middle = (low*at_high - high*at_low)/(at_high - at_low)
         if (modulo(k, 3) == 0 .or. .not. (middle > low .and. middle < high)) middle = (low + high)/2
         if (.not. (middle > low .and. middle < high)) exit
         if (value_at(middle) > 0) then
            low = middle
            at_low = value_at(low)
         else
            high = middle
            at_high = value_at(high)
            if (.not. abs(at_high) > 0) exit
         end if
         if (high - low < 4*epsilon(1.0_dp)) exit
      end do
      root = high

   contains

      !> The polynomial.
      pure real(dp) function value_at(s)
         real(dp), intent(in) :: s
         real(dp) :: weights(n_nodes)

         call get_weights(s, weights)
         value_at = dot_product(weights, values)
      end function value_at

   end function find_fall

   !> The last of the panels that have begun at a time; 1 before all.
   pure integer function last_begun(clocks, clock) result(panel)
      !> Times at their begins, one at least, none below the one before.
      real(dp), intent(in) :: clocks(:)
      !> The time.
      real(dp), intent(in) :: clock
      integer :: high, middle

      panel = 1
      high = size(clocks)
      do while (panel < high)
         middle = (panel + high + 1)/2
         if (clocks(middle) <= clock) then
            panel = middle
         else
            high = middle - 1
         end if
      end do
   end function last_begun

end module adfric_numerics_time_panels
