! SPDX-License-Identifier: GPL-3.0-or-later
!> Where the work goes that an indenter does on viscoelastic springs.
!>
!> A spring stores \( u = E_0 \theta^2 + \sum_i E_i q_i^2 \) and loses \( 2 \sum_i (E_i/t_i) q_i^2 \) per time. Springs in contact are
!> summed by \( A_i = \int_0^a q_i^2 dx \), \( \dot A_i = -2 A_i/t_i + 2 \dot\delta Q_i + q_i(a)^2 \dot a \). A spring that passes the
!> edge takes its u along. So the work is what springs in contact store and have lost, and what left with others: that this holds is
!> a certificate of a run, for none of these sums enters the solution.
module adfric_round_timed_energy
   use adfric_base_kinds, only: dp
   use adfric_interface_normal_contact, only: normal_state_t
   use adfric_numerics_time_panels, only: get_memory, n_nodes, panel_nodes, panel_slopes, panel_sums
   use adfric_round_timed_panel, only: timed_panel_t
   use adfric_round_timed_path, only: time_between
   use adfric_round_timed_springs, only: get_spot, mark_of, timed_springs_t
   implicit none (type, external)
   private
   public :: timed_energy_t, start_energy, add_panel, add_face, end_contact, stored_in_contact, stored_free

   !> Energies up to an instant, in units of the springs.
   type :: timed_energy_t
      !> Work of the load, what springs in contact have lost, and what left contact with springs less what came with them.
      real(dp) :: work = 0, lost = 0, carried = 0
      !> A_i; shape `(n_arms)`.
      real(dp), allocatable :: squares(:)
      !> Largest work so far.
      real(dp) :: largest_work = 0
   end type timed_energy_t

contains

   !> Nothing yet.
   pure subroutine start_energy(self, n_arms)
      type(timed_energy_t), intent(out) :: self
      !> Number of arms.
      integer, intent(in) :: n_arms

      allocate (self%squares(n_arms), source=0.0_dp)
   end subroutine start_energy

   !> Add a panel in contact.
   pure subroutine add_panel(self, springs, panel)
      type(timed_energy_t), intent(inout) :: self
      type(timed_springs_t), intent(in) :: springs
      type(timed_panel_t), intent(in) :: panel
      real(dp), dimension(n_nodes) :: rate, radius_rate, edge, squares
      real(dp) :: memory(n_nodes, n_nodes)
      integer :: i

      rate = matmul(panel_slopes, panel%rise)
      radius_rate = matmul(panel_slopes, panel%radius)
      self%work = self%work + dot_product(panel_sums, panel%load*rate)
      self%largest_work = max(self%largest_work, self%work)
      edge = springs%relaxed*(panel%approach - panel%depth)**2
      do i = 1, size(springs%times)
         associate (arm => springs%moduli(i), decay => panel%span/springs%times(i))
            edge = edge + arm*panel%at_edge(:, i)**2
            call get_memory(decay, memory)
            squares = self%squares(i)*exp(-decay*(panel_nodes + 1)) + matmul(memory, 2*rate*panel%sums(:, i) &
               & + panel%at_edge(:, i)**2*radius_rate)
            self%squares(i) = squares(n_nodes)
            ! 2 E/t A dt, and dt = span/2 ds
            self%lost = self%lost + arm*decay*dot_product(panel_sums, squares)
         end associate
      end do
      self%carried = self%carried - dot_product(panel_sums, edge*radius_rate)
   end subroutine add_panel

   !> The springs of a flat face come into contact all at once.
   pure subroutine add_face(self, springs)
      type(timed_energy_t), intent(inout) :: self
      !> The springs just after it.
      type(timed_springs_t), intent(in) :: springs

      self%carried = self%carried - springs%radius*edge_energy(springs)
      self%squares = springs%radius*springs%at_edge**2
   end subroutine add_face

   !> The springs that are left, of a flat face or as good as none, leave contact all at once.
   pure subroutine end_contact(self, springs)
      type(timed_energy_t), intent(inout) :: self
      !> The springs just before it.
      type(timed_springs_t), intent(in) :: springs

      self%carried = self%carried + springs%radius*edge_energy(springs)
      self%squares = 0
   end subroutine end_contact

   !> Energy of the spring at the edge.
   pure real(dp) function edge_energy(springs)
      type(timed_springs_t), intent(in) :: springs

      edge_energy = springs%relaxed*(springs%approach - springs%depth)**2 + sum(springs%moduli*springs%at_edge**2)
   end function edge_energy

   !> Energy that springs in contact store.
   pure real(dp) function stored_in_contact(self, springs) result(stored)
      type(timed_energy_t), intent(in) :: self
      type(timed_springs_t), intent(in) :: springs
      type(normal_state_t) :: state
      real(dp) :: moment
      logical :: is_converged

      stored = 0
      if (.not. springs%radius > 0) return
      call springs%contacts%at_approach(max(springs%depth, 0.0_dp), state, is_converged)
      ! int (delta - g)^2 dx from int (g(a) - g)^2 dx, which is the elastic energy
      moment = state%radius*springs%depth - state%load/2
      associate (beyond => springs%approach - springs%depth)
         stored = springs%relaxed*(state%work + beyond*(2*(springs%depth*state%radius - moment) + beyond*state%radius)) &
            & + sum(springs%moduli*self%squares)
      end associate
   end function stored_in_contact

   !> Energy that free springs store.
   pure real(dp) function stored_free(springs) result(stored)
      type(timed_springs_t), intent(in) :: springs
      real(dp), dimension(n_nodes) :: radius, moment, depth, energy
      real(dp) :: memory(size(springs%times)), middle, half, since
      integer :: piece, j

      stored = 0
      do piece = 1, springs%free%count
         since = time_between(springs%legs, springs%free%marks(piece), mark_of(springs))
         associate (ends => springs%free%ends(:, piece), free => springs%free)
            middle = (ends(1) + ends(2))/2
            half = (ends(2) - ends(1))/2
            do j = 1, n_nodes
               associate (s => middle + half*panel_nodes(j))
                  call free%read_at(piece, s, depth(j), memory)
                  energy(j) = energy_of(springs, memory*exp(-free%lag_of(piece, s, since)*free%rates))
               end associate
            end do
            call get_spot(springs%contacts, depth, radius, moment)
            stored = stored - dot_product(panel_sums, energy*matmul(panel_slopes, radius))
         end associate
      end do
      ! what left all at once
      if (springs%free%count > 0 .and. .not. springs%radius > 0) stored = stored + springs%lost_radius*energy(n_nodes)
   end function stored_free

   !> Energy of a free spring.
   pure real(dp) function energy_of(springs, memory)
      type(timed_springs_t), intent(in) :: springs
      !> c_k by now.
      real(dp), intent(in) :: memory(:)

      energy_of = springs%relaxed*sum(memory)**2 + sum(springs%moduli*matmul(springs%states, memory)**2)
   end function energy_of

end module adfric_round_timed_energy
