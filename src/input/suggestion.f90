! SPDX-License-Identifier: GPL-3.0-or-later
!> What the user may have meant: the nearest of the words that are known.
module adfric_input_suggestion
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_base_text, only: to_lower
   implicit none (type, external)
   private
   public :: edit_distance, find_nearest, did_you_mean

   !> A beginning of this length is enough to recognise a word.
   integer, parameter :: shortest_beginning = 3
   !> What others call a variable, and its name here.
   character(*), parameter :: synonyms(2, 20) = reshape([character(20) :: &
      & 'contact_modulus', 'modulus', 'modulus', 'contact_modulus', 'elastic_modulus', 'young_modulus', &
      & 'e_modulus', 'young_modulus', 'nu', 'poisson_ratio', &
      & 'relaxation_time', 'relaxation_times', 'retardation_ratio', 'moduli', &
      & 'pressure', 'mean_pressure', 'force', 'load', 'normal_force', 'load', &
      & 'indentation', 'approach', 'depth', 'approach', 'speed', 'velocity', 'sliding_velocity', 'velocity', &
      & 'wavelength', 'period', 'friction_coefficient', 'coulomb_coefficient', 'mu', 'coulomb_coefficient', &
      & 'surface_energy', 'work_of_adhesion', 'adhesion_energy', 'work_of_adhesion', 'hold_time', 'dwell_time'], [2, 20])

contains

   !> Number of letters to insert, delete, replace or swap with their neighbour that make one word the other.
   pure integer function edit_distance(a, b)
      !> The two words; small letters and capitals differ.
      character(*), intent(in) :: a, b
      !> Rows i - 2, i - 1 and i of the table of distances between the beginnings of a and b.
      integer :: previous(-1:len(b)), last(-1:len(b)), row(-1:len(b))
      integer :: i, j, change

      previous = 0
      row = 0
      last = [(j, j=-1, len(b))]
      do i = 1, len(a)
         row(0) = i
         do j = 1, len(b)
            change = merge(0, 1, a(i:i) == b(j:j))
            row(j) = min(last(j) + 1, row(j - 1) + 1, last(j - 1) + change)
            if (i == 1 .or. j == 1) cycle
            if (a(i:i) == b(j - 1:j - 1) .and. a(i - 1:i - 1) == b(j:j)) row(j) = min(row(j), previous(j - 2) + 1)
         end do
         previous = last
         last = row
      end do
      edit_distance = last(len(b))
   end function edit_distance

   !> The known word that another name of the field means, or that is near enough in its letters; empty if there is none. Capitals
   !> do not count.
   pure function find_nearest(word, known) result(nearest)
      !> The word that is not known, with any capitals.
      character(*), intent(in) :: word
      !> Words that may be meant, separated by a blank.
      character(*), intent(in) :: known
      character(:), allocatable :: nearest, candidate, lower
      integer :: k, distance, best

      nearest = ''
      lower = to_lower(trim(word))
      do k = 1, size(synonyms, 2)
         if (synonyms(1, k) /= lower .or. .not. has_word(known, trim(synonyms(2, k)))) cycle
         nearest = trim(synonyms(2, k))
         return
      end do
      best = max(1, len(lower)/3) + 1
      do k = 1, count_words(known)
         candidate = get_word(known, k)
         ! every letter too many has to be deleted
         if (abs(len(lower) - len(candidate)) >= best) cycle
         distance = edit_distance(lower, to_lower(candidate))
         if (distance >= best) cycle
         best = distance
         nearest = candidate
      end do
      if (len(nearest) > 0 .or. len(lower) < shortest_beginning) return
      do k = 1, count_words(known)
         candidate = get_word(known, k)
         if (index(to_lower(candidate), lower) /= 1) cycle
         nearest = candidate
         return
      end do
   end function find_nearest

   !> The end of a message: `; did you mean 'velocity'?`, or nothing.
   pure function did_you_mean(word, known) result(question)
      !> The word that is not known, with any capitals.
      character(*), intent(in) :: word
      !> Words that may be meant, separated by a blank.
      character(*), intent(in) :: known
      character(:), allocatable :: question

      question = find_nearest(word, known)
      if (len(question) > 0) question = '; did you mean '''//question//'''?'
   end function did_you_mean

end module adfric_input_suggestion
