! SPDX-License-Identifier: GPL-3.0-or-later
!> The page of `adfric help` on theories of rough contact: what they are, and how far they have been from the numerical answer.
module adfric_command_help_theories
   use adfric_base_text, only: newline
   use adfric_base_words, only: pad
   use adfric_rough_atlas, only: describe_atlas
   use adfric_rough_atlas_others, only: describe_parting, describe_sliding
   use adfric_rough_variables, only: meanings, n_theories, suffixes
   implicit none (type, external)
   private
   public :: describe_theories

contains

   !> The whole page.
   function describe_theories() result(text)
      character(:), allocatable :: text
      integer :: k

      text = 'Theories of a rough surface with a power spectrum (&surface kind = ''spectrum''). Results end with:'//newline//newline
      do k = 1, n_theories
         text = text//'  '//pad(trim(suffixes(k)), 22)//trim(meanings(k))//newline
      end do
      text = text//newline// &
         & 'Largest error [%] beside surface_elastic, of 12 self-affine spectra with Hurst exponents from 0.3 to 0.8,'//newline// &
         & 'longest waves of 1.3 to 64 times the shortest one, and Nayak''s parameters from 1.5 to 118.'//newline// &
         & 'p is the mean pressure, E the contact modulus, g the root mean square gradient:'//newline//newline// &
         & describe_atlas()//newline// &
         & describe_parting()//newline//describe_sliding()//newline// &
         & 'adfric check says which theory would do for an input. Of each spectrum, with errors:'//newline// &
         & '  docs/validation/theories.md, by bench/run theories'//newline// &
         & 'How they are computed: docs/theory/rough_theories.md'//newline
   end function describe_theories

end module adfric_command_help_theories
