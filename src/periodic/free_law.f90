! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesion of the model `free_surface`: what its rows say, and how well the cells see it.
module adfric_periodic_free_law
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_describe_table, only: variable_t
   use adfric_interface_adhesion_rows, only: adhesion_law_t, check_adhesion, has_adhesion, n_adhesion_rows, &
      & resolve_adhesion
   use adfric_periodic_adhesive_solver, only: adhesion_in_units, periodic_adhesion_t
   use adfric_periodic_free_rows, only: in => free_input
   use adfric_periodic_point, only: periodic_solid_t, periodic_surface_t
   use adfric_periodic_variables, only: is_wanted
   use adfric_solid_contact_modulus, only: contact_modulus_of, n_two_bodies
   implicit none (type, external)
   private
   public :: check_free_law, free_law_in_units, free_law_of, set_free_solid

   !> Stress over E*, and range over the length of the map, that are taken.
   real(dp), parameter :: least_size = 1.0e-12_dp, largest_size = 1.0e4_dp

contains

   !> The law of a point, whose stress is 0 without adhesion [Pa, m]; a load of a turn stands as its pressure [N].
   type(adhesion_law_t) function free_law_of(values) result(law)
      !> Values of all variables of the model.
      real(dp), intent(in) :: values(:)

      call resolve_adhesion(values(in%adhesion:in%adhesion + n_adhesion_rows - 1), law)
   end function free_law_of

   !> Add to `problems` what is wrong with adhesion, and what has no meaning without it.
   subroutine check_free_law(rows, values, problems)
      !> Variables of the model, and their values.
      type(variable_t), intent(in) :: rows(:)
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      type(adhesion_law_t) :: law
      real(dp) :: sizes(2)
      integer :: n_before

      n_before = problems%count()
      associate (first => in%adhesion, last => in%adhesion + n_adhesion_rows - 1)
         call check_adhesion(rows(first:last), values(first:last), problems)
         if (problems%count() > n_before) return
         if (.not. has_adhesion(values(first:last))) then
            if (is_set(values(in%load))) then
               if (values(in%load) < 0) call problems%add('operating', 'load', 'is below 0, but nothing pulls without &adhesion')
            end if
            if (is_wanted(values(in%pull_off))) call problems%add('output', 'pull_off', 'has no meaning without &adhesion')
            return
         end if
      end associate
      if (problems%count() > 0) return
      law = free_law_of(values)
      sizes = [law%stress/contact_modulus_of(values(in%modulus:in%modulus + n_two_bodies - 1)), law%range/values(in%length_x)]
      if (.not. all(sizes >= least_size .and. sizes <= largest_size)) call problems%add('adhesion', 'stress', 'or its range is ' &
         & //'too small or too large for the body: stress/E* and range/length_x are 1e-12 to 1e4')
   end subroutine check_free_law

   !> The law in units of E* and of a length; a load of a turn in E* times the square of the length.
   type(periodic_adhesion_t) function free_law_in_units(law, modulus, unit) result(adhesion)
      !> The law [Pa, m, N], with a stress above 0.
      type(adhesion_law_t), intent(in) :: law
      !> Contact modulus E* [Pa], and unit of length [m].
      real(dp), intent(in) :: modulus, unit

      adhesion = adhesion_in_units(law, modulus)
      adhesion%range = adhesion%range/unit
      adhesion%turning_pressure = adhesion%turning_pressure/unit/unit
   end function free_law_in_units

   !> Give a surface its solid, for what its cells see of adhesion.
   pure subroutine set_free_solid(values, surface)
      !> Values of all variables of the model.
      real(dp), intent(in) :: values(:)
      !> Receives the solid.
      type(periodic_surface_t), intent(inout) :: surface

      if (.not. allocated(surface%solid)) allocate (periodic_solid_t :: surface%solid)
      surface%solid%modulus = contact_modulus_of(values(in%modulus:in%modulus + n_two_bodies - 1))
   end subroutine set_free_solid

end module adfric_periodic_free_law
