! SPDX-License-Identifier: GPL-3.0-or-later
!> Random cases of every model: does any break a rule that must hold? See bench/README.md.
!>
!> random_search [SECONDS [SEED [MODEL]]]
program random_search
   use adfric, only: known_models
   use adfric_base_kinds, only: dp
   use adfric_base_words, only: count_words, get_word
   use adfric_describe_status, only: status_not_converged, status_solved
   use measure, only: integer_argument, text_argument
   use search_loop, only: search_t, search_model
   implicit none (type, external)

   !> A case that takes longer ends the search [s].
   integer, parameter :: longest = 120
   type(search_t) :: search
   character(:), allocatable :: only_model, models
   integer :: k, seconds, seed, n_faults

   seconds = integer_argument(1, 60)
   seed = integer_argument(2, 1)
   only_model = text_argument(3, '')
   models = known_models
   if (len(only_model) > 0) models = only_model
   n_faults = 0
   print '(a, i0, a, i0, a)', 'random_search: ', seconds, ' s for all models, seed ', seed, '; what breaks goes to standard error'
   print '(a16, 6a12)', 'model', 'cases', 'solved', 'no state', 'no conv', 'us/point', 'slowest us'
   do k = 1, count_words(models)
      call search_model(get_word(models, k), seed, huge(seed), real(seconds, dp)/count_words(models), longest, search)
      print '(a16, 4i12, 2f12.1)', get_word(models, k), search%n_cases, &
         search%by_status(status_solved:status_not_converged), &
         1.0e6_dp*search%seconds/max(1, sum(search%by_status)), 1.0e6_dp*search%slowest
      if (search%n_faults > 0) print '(a16, i12, a)', '', search%n_faults, ' broken'
      n_faults = n_faults + search%n_faults
   end do
   if (n_faults > 0) stop 1
end program random_search
