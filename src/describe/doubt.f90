! SPDX-License-Identifier: GPL-3.0-or-later
!> Doubts: how far a theory holds, and whether a point lies beyond. Each bound stands where its theory may be off by about a tenth
!> (docs/reference/doubts.md derives them).
!>
!> A model measures at a point what the bounds of its theory are compared with, and what it does not measure is not doubted. A point
!> beyond several bounds has the doubt that stands first in the list, which goes from the geometry that a theory assumes to the digits
!> of its result and the strength of the solid. A doubt is no failure: the results stay what the theory says.
module adfric_describe_doubt
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: doubt_none, doubt_contact_too_wide, doubt_slope_too_steep, doubt_layer_too_thick, doubt_estimate_above_tenth
   public :: doubt_beyond_yield, n_doubts, doubt_name, doubt_meanings, doubt_limits, not_measured
   public :: find_doubt, raise_measures, explain_doubt, quantity_of

   !> Doubts of a point, as they stand in the file.
   integer, parameter :: doubt_none = 0, doubt_contact_too_wide = 1, doubt_slope_too_steep = 2, doubt_layer_too_thick = 3, &
      & doubt_estimate_above_tenth = 4, doubt_beyond_yield = 5
   integer, parameter :: n_doubts = 5
   !> Name of the result.
   character(*), parameter :: doubt_name = 'doubt'
   !> Names of the doubts, in the order of their numbers from 0.
   character(*), parameter :: doubt_meanings = 'none contact_too_wide slope_too_steep layer_too_thick estimate_above_tenth '// &
      & 'beyond_yield'
   !> What is measured is doubted from these numbers on.
   real(dp), parameter :: doubt_limits(n_doubts) = [0.5_dp, 0.5_dp, 0.25_dp, 0.1_dp, 1.0_dp]
   !> What stands for a number that a model does not measure.
   real(dp), parameter :: not_measured = -1

contains

   !> The doubt of a point.
   pure integer function find_doubt(measures) result(doubt)
      !> What has been measured, in the order of the doubts; NaN or `not_measured` where that is not known; shape `(n_doubts)`.
      real(dp), intent(in) :: measures(:)

      do doubt = 1, n_doubts
         if (ieee_is_nan(measures(doubt))) cycle
         if (measures(doubt) >= doubt_limits(doubt)) return
      end do
      doubt = doubt_none
   end function find_doubt

   !> Let measures rise to those of a point.
   pure subroutine raise_measures(of_point, measures)
      !> What has been measured at the point; NaN or `not_measured` where that is not known; shape `(n_doubts)`.
      real(dp), intent(in) :: of_point(:)
      !> The largest so far; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)
      integer :: doubt

      do doubt = 1, n_doubts
         if (.not. ieee_is_nan(of_point(doubt))) measures(doubt) = max(measures(doubt), of_point(doubt))
      end do
   end subroutine raise_measures

   !> What is measured for a doubt.
   pure function quantity_of(doubt) result(text)
      !> One of `doubt_...`, not `doubt_none`.
      integer, intent(in) :: doubt
      character(:), allocatable :: text

      select case (doubt)
      case (doubt_contact_too_wide)
         text = 'half-width of contact over radius of the body'
      case (doubt_slope_too_steep)
         text = 'slope of the surface'
      case (doubt_layer_too_thick)
         text = 'thickness of the layer over the shortest wave'
      case (doubt_beyond_yield)
         text = 'largest von Mises stress over the yield strength'
      case default
         text = 'error_estimate'
      end select
   end function quantity_of

   !> What a doubt means, in a sentence.
   pure function explain_doubt(doubt) result(text)
      !> One of `doubt_...`.
      integer, intent(in) :: doubt
      character(:), allocatable :: text

      select case (doubt)
      case (doubt_none)
         text = 'the point lies within the bounds of its theory'
      case (doubt_contact_too_wide)
         text = 'half-width of contact >= 0.5 radius of the body: off by a tenth or more'
      case (doubt_slope_too_steep)
         text = 'slope >= 0.5, and small slopes are assumed: off by a tenth or more'
      case (doubt_layer_too_thick)
         text = 'thickness >= a quarter of the shortest wave: columns are off by a tenth or more'
      case (doubt_beyond_yield)
         text = 'largest von Mises stress >= the yield strength: the solid is not elastic'
      case default
         text = 'error_estimate >= 0.1'
      end select
   end function explain_doubt

end module adfric_describe_doubt
