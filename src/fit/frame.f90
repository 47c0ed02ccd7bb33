! SPDX-License-Identifier: GPL-3.0-or-later
!> What all points of a curve of the model `sphere` have in common at one set of variables: X = X0 phi + x0, Y = Y0 y + y0.
module adfric_fit_frame
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_fit_curve, only: nuisance_slopes
   use adfric_fit_ordinate, only: get_unit
   use adfric_fit_problem, only: free_t, n_nuisances, nuisance_load_offset, nuisance_friction_offset, nuisance_contact_point, &
      & nuisance_lateral_gain, nuisance_spring_stiffness, nuisance_tilt
   use adfric_fit_sphere_basis, only: basis_t, of_radius, of_modulus, of_work, of_lambda, of_edge
   use adfric_round_sphere_variables, only: out => sphere_output
   implicit none (type, external)
   private
   public :: frame_t, new_frame, set_frame

   !> What all points of a curve have in common at one set of variables.
   type :: frame_t
      !> Units and zeros of abscissa and ordinate.
      real(dp) :: x_unit = 1, y_unit = 1, x_zero = 0, y_zero = 0
      !> Slope of the base line.
      real(dp) :: tilt = 0
      !> Changes by each free variable: logarithms of both units, zeros, lambda, ks, x.
      real(dp), allocatable, dimension(:) :: x_unit_by, y_unit_by, x_zero_by, y_zero_by, lambda_by, ks_by, edge_by
      !> Change of the zero of a load, and of the slope of the base line.
      real(dp), allocatable :: load_zero_by(:), tilt_by(:)
   end type frame_t

contains

   !> Make space.
   pure subroutine new_frame(self, n)
      type(frame_t), intent(out) :: self
      !> Number of free variables.
      integer, intent(in) :: n

      allocate (self%x_unit_by(n), self%y_unit_by(n), self%x_zero_by(n), self%y_zero_by(n), self%lambda_by(n), self%ks_by(n), &
         & self%edge_by(n), self%load_zero_by(n), self%tilt_by(n), source=0.0_dp)
   end subroutine new_frame

   !> Units and zeros, and how they change.
   pure subroutine set_frame(c, basis, frees, data_set, ordinate, is_base, nuisance, slopes, ks)
      type(frame_t), intent(inout) :: c
      type(basis_t), intent(in) :: basis
      type(free_t), intent(in) :: frees(:)
      !> Number of the data set, and its ordinate, a position in the results.
      integer, intent(in) :: data_set, ordinate
      !> Is the abscissa the position of a base, not the load?
      logical, intent(in) :: is_base
      real(dp), intent(in) :: nuisance(:), slopes(:)
      !> Receives the reduced compliance L/(k D) of the spring.
      real(dp), intent(out) :: ks
      real(dp) :: of_nuisance(size(slopes), n_nuisances)

      call nuisance_slopes(frees, data_set, slopes, of_nuisance)
      associate (b => basis%by_free)
         c%lambda_by = basis%lambda*b(:, of_lambda)
         c%edge_by = b(:, of_edge)
         c%load_zero_by = of_nuisance(:, nuisance_load_offset)
         ks = 0
         c%ks_by = 0
         if (is_base .and. is_set(nuisance(nuisance_spring_stiffness))) then
            ks = basis%force/(nuisance(nuisance_spring_stiffness)*basis%approach)
            c%ks_by = ks*((b(:, of_work) + 2*b(:, of_radius) + 2*b(:, of_modulus))/3 &
               & - of_nuisance(:, nuisance_spring_stiffness)/nuisance(nuisance_spring_stiffness))
         end if
         call get_unit(ordinate, basis, c%y_unit, c%y_unit_by)
         c%y_unit = c%y_unit*nuisance(nuisance_lateral_gain)
         c%y_unit_by = c%y_unit_by + of_nuisance(:, nuisance_lateral_gain)/nuisance(nuisance_lateral_gain)
         c%y_zero = nuisance(nuisance_friction_offset)
         c%y_zero_by = of_nuisance(:, nuisance_friction_offset)
         if (ordinate == out%load) c%y_zero = c%y_zero + nuisance(nuisance_load_offset)
         if (ordinate == out%load) c%y_zero_by = c%y_zero_by + c%load_zero_by
         c%tilt = nuisance(nuisance_tilt)
         c%tilt_by = of_nuisance(:, nuisance_tilt)
         if (is_base) then
            c%x_unit = basis%approach
            c%x_unit_by = (2*b(:, of_work) + b(:, of_radius) - 2*b(:, of_modulus))/3
            c%x_zero = nuisance(nuisance_contact_point)
            c%x_zero_by = of_nuisance(:, nuisance_contact_point)
         else
            c%x_unit = basis%force
            c%x_unit_by = b(:, of_work) + b(:, of_radius)
            c%x_zero = nuisance(nuisance_load_offset)
            c%x_zero_by = c%load_zero_by
         end if
      end associate
   end subroutine set_frame

end module adfric_fit_frame
