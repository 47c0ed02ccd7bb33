! SPDX-License-Identifier: GPL-3.0-or-later
!> What has become of a point.
module adfric_describe_status
   implicit none (type, external)
   private
   public :: status_solved, status_no_equilibrium, status_not_converged, status_not_identifiable, status_out_of_memory
   public :: status_stopped, n_status, status_meanings, explain_status

   !> Status of a point, as it stands in the file. The last one is of fits alone.
   integer, parameter :: status_solved = 0, status_no_equilibrium = 1, status_not_converged = 2
   integer, parameter :: status_not_identifiable = 3
   integer, parameter :: n_status = 4
   !> What a model gives back for a point that there is too little memory for. It stands in no file: such a run ends with an error.
   integer, parameter :: status_out_of_memory = -1
   !> What a model gives back for a point that it has not solved, since the run shall end. It stands in no file either.
   integer, parameter :: status_stopped = -2
   !> Names of the states, in the order of their numbers from 0.
   character(*), parameter :: status_meanings = 'solved no_equilibrium not_converged'

contains

   !> What a status means, in a sentence.
   pure function explain_status(status) result(text)
      !> One of `status_...`.
      integer, intent(in) :: status
      character(:), allocatable :: text

      select case (status)
      case (status_solved)
         text = 'the state was found; the point has its results'
      case (status_no_equilibrium)
         text = 'there is no such state, which is an answer; results that need one are NaN'
      case default
         text = 'the state was not found to the tolerance; the results are NaN'
      end select
   end function explain_status

end module adfric_describe_status
