! SPDX-License-Identifier: GPL-3.0-or-later
!> The 2-D wave that adheres to a half-space by each law of attraction: time and pairs of transforms against error. See bench/README.md.
!>
!> All laws have the same work of adhesion and the same largest tension.
!>
!> adhesion_laws [TABLE.csv]
program adhesion_laws
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_interface_attraction, only: attraction_of_two, law_dugdale, law_exponential, law_linear, law_van_der_waals, law_words
   use adfric_base_unset, only: unset
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t, solve_adhesive_load
   use adfric_periodic_area, only: relative_error_of
   use adfric_periodic_attracted_surface, only: periodic_attraction_t, solve_attracted_load
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, new_periodic_solver, contact_solved
   use adfric_system_clock, only: wall_clock
   use measure, only: print_heading, text_argument, open_table
   use trial_surfaces, only: wave
   implicit none (type, external)

   !> Height of the wave from trough to crest, over its length.
   real(dp), parameter :: height = 0.63661977236758134_dp
   !> Largest tension over E*, range of Dugdale's law over the wavelength, loads over E*.
   real(dp), parameter :: stress = 0.3_dp, range = 0.0477464829_dp, loads(*) = [0.02_dp, 0.1_dp, 0.3_dp], tolerance = 1.0e-10_dp
   integer, parameter :: laws(*) = [law_dugdale, law_exponential, law_linear, law_van_der_waals], n_states = 2*size(loads)
   !> Cells along a period; the last ones are the truth.
   integer, parameter :: cells(*) = [32, 64, 128, 256, 512]

   !> States of a law on cells.
   type :: states_t
      !> Seconds, pairs of transforms, contact fractions with their estimated errors, and mean gaps over the height.
      real(dp) :: seconds(n_states) = 0, pairs(n_states) = 0, contact(n_states) = 0, estimate(n_states) = 0, gap(n_states) = 0
   end type states_t
   type(states_t) :: states(size(cells))
   integer :: table, k, i

   call print_heading('A wave that adheres by each law of attraction')
   table = open_table(text_argument(1, 'adhesion_laws.csv'), &
      & 'law,cells,ms_least,ms_most,pairs_least,pairs_most,contact_error,gap_error,above')
   print '(a15, a7, 2a10, 2a8, 2a12, a8)', 'law', 'cells', 'least ms', 'most ms', 'pairs', 'most', 'contact', 'mean gap', 'above'
   do k = 1, size(laws)
      do i = 1, size(cells)
         call solve_states(laws(k), cells(i), states(i))
      end do
      do i = 1, size(cells) - 1
         call report(word_of(laws(k)), cells(i), states(i), states(size(cells)))
      end do
   end do
   close (table)

contains

   !> Solve both branches under all loads.
   subroutine solve_states(law, n, found)
      !> One of `law_...`.
      integer, intent(in) :: law
      !> Cells along a period.
      integer, intent(in) :: n
      type(states_t), intent(out) :: found
      type(periodic_solver_t) :: solver
      type(periodic_solution_t) :: solution
      type(periodic_attraction_t) :: attraction
      type(error_t), allocatable :: error
      real(dp), allocatable :: shape(:, :)
      real(dp) :: lowest
      integer :: i, branch, state

      allocate (shape, source=wave(n, n/2))
      lowest = minval(shape)
      shape(:, :) = shape - lowest
      attraction%law = attraction_of_two(law, stress, stress*range, unset)
      call new_periodic_solver(solver, elastic_kernel_t(), [n/2, n/2], [1.0_dp, 1.0_dp], .true., error)
      state = 0
      do i = 1, size(loads)
         do branch = 1, 2
            state = state + 1
            found%seconds(state) = wall_clock()
            if (law == law_dugdale) then
               call solve_adhesive_load(solver, shape, loads(i), periodic_adhesion_t(stress, range, branch == 1), tolerance, &
                  & solution, error)
            else
               attraction%is_adhered = branch == 1
               call solve_attracted_load(solver, shape, loads(i), attraction, tolerance, solution, error)
            end if
            found%seconds(state) = wall_clock() - found%seconds(state)
            if (solution%status /= contact_solved) error stop 'a state was not found'
            found%pairs(state) = solution%n_pairs
            found%contact(state) = solution%area%corrected
            found%estimate(state) = relative_error_of(solution%area)
            found%gap(state) = sum(solution%gap)/size(solution%gap)/height
         end do
      end do
   end subroutine solve_states

   !> The word of a law.
   pure function word_of(law) result(word)
      integer, intent(in) :: law
      character(16) :: word
      character(16) :: words(6)
      character(len(law_words)) :: text

      text = law_words
      read (text, *) words
      word = words(law)
   end function word_of

   !> Print and write a line.
   subroutine report(law, n, found, truth)
      character(*), intent(in) :: law
      integer, intent(in) :: n
      type(states_t), intent(in) :: found
      !> The same on the finest cells.
      type(states_t), intent(in) :: truth
      real(dp) :: errors(n_states)
      integer :: n_above

      errors = abs(found%contact/truth%contact - 1)
      n_above = count(errors > found%estimate)
      print '(a15, i7, 2f10.2, 2f8.0, 2es12.1, i8)', law, n, 1000*minval(found%seconds), 1000*maxval(found%seconds), &
         & minval(found%pairs), maxval(found%pairs), maxval(errors), maxval(abs(found%gap - truth%gap)), n_above
      write (table, '(a, ",", i0, 2(",", f0.2), 2(",", f0.1), 2(",", es9.2), ",", i0)') trim(law), n, 1000*minval(found%seconds), &
         & 1000*maxval(found%seconds), minval(found%pairs), maxval(found%pairs), maxval(errors), &
         & maxval(abs(found%gap - truth%gap)), n_above
   end subroutine report

end program adhesion_laws
