! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesion of the model `free_surface`: what its rows say, and how well the cells see it.
module adfric_periodic_free_law
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_describe_table, only: variable_t
   use adfric_interface_adhesion_rows, only: adhesion_law_t
   use adfric_interface_attraction_rows, only: check_attraction, given_attraction_t, has_attraction, has_wall_at_contact, &
      & resolve_attraction
   use adfric_periodic_adhesive_solver, only: adhesion_in_units
   use adfric_periodic_attracted_surface, only: attraction_in_units
   use adfric_periodic_free_attraction, only: free_law_t
   use adfric_periodic_free_rows, only: attraction_values, in => free_input
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
   pure type(adhesion_law_t) function free_law_of(values, given) result(law)
      !> Values of all variables of the model.
      real(dp), intent(in) :: values(:)
      !> Table of the law, if there is one.
      type(given_attraction_t), intent(in) :: given

      call resolve_attraction(attraction_values(values), given, law)
   end function free_law_of

   !> Add to `problems` what is wrong with adhesion, and what has no meaning without it.
   subroutine check_free_law(rows, values, given, problems)
      !> Variables of the model, and their values.
      type(variable_t), intent(in) :: rows(:)
      real(dp), intent(in) :: values(:)
      !> Table of the law, if there is one.
      type(given_attraction_t), intent(in) :: given
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      type(adhesion_law_t) :: law
      real(dp) :: sizes(2)
      integer :: n_before

      n_before = problems%count()
      call check_attraction(rows(in%adhesion:in%tension_table), attraction_values(values), given, problems)
      if (.not. has_wall_at_contact(attraction_values(values))) call problems%add(rows(in%law)%group, rows(in%law)%name, &
         & 'is ''lennard_jones'', which has no wall: cells beyond the body, which nothing holds, have no state')
      if (problems%count() > n_before) return
      if (.not. has_attraction(attraction_values(values))) then
         if (is_set(values(in%load))) then
            if (values(in%load) < 0) call problems%add('operating', 'load', 'is below 0, but nothing pulls without &adhesion')
         end if
         if (is_wanted(values(in%pull_off))) call problems%add('output', 'pull_off', 'has no meaning without &adhesion')
         return
      end if
      if (problems%count() > 0) return
      law = free_law_of(values, given)
      ! a table that is not known yet
      if (.not. law%stress > 0) return
      sizes = [law%stress/contact_modulus_of(values(in%modulus:in%modulus + n_two_bodies - 1)), law%range/values(in%length_x)]
      if (.not. all(sizes >= least_size .and. sizes <= largest_size)) call problems%add('adhesion', 'stress', 'or its range is ' &
         & //'too small or too large for the body: stress/E* and range/length_x are 1e-12 to 1e4')
   end subroutine check_free_law

   !> The law in units of E* and of a length; a load of a turn in E* times the square of the length.
   pure type(free_law_t) function free_law_in_units(law, modulus, unit) result(adhesion)
      !> The law [Pa, m, N], with a stress above 0.
      type(adhesion_law_t), intent(in) :: law
      !> Contact modulus E* [Pa], and unit of length [m].
      real(dp), intent(in) :: modulus, unit

      adhesion%dugdale = adhesion_in_units(law, modulus)
      if (allocated(adhesion%dugdale%law)) deallocate (adhesion%dugdale%law)
      adhesion%dugdale%range = adhesion%dugdale%range/unit
      adhesion%dugdale%turning_pressure = adhesion%dugdale%turning_pressure/unit/unit
      if (.not. allocated(law%attraction)) return
      adhesion%attraction = attraction_in_units(law, modulus)
      adhesion%attraction = adhesion%attraction%in_length(unit)
      adhesion%attraction%turning_pressure = adhesion%dugdale%turning_pressure
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
