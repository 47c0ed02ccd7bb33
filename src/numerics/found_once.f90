! SPDX-License-Identifier: GPL-3.0-or-later
!> What threads share that is found once: a few numbers that follow from other numbers, its key. The first thread that asks for a key
!> finds its numbers, all others look them up, or wait for them while it does. Keys that differ are sought at the same time.
!>
!>     call table%look_up(key, numbers, is_known, search)
!>     if (.not. is_known) then
!>        ... find the numbers ...
!>        call table%keep(search, numbers)      (or give_up, if that was not possible)
!>     end if
!>
!> What is found must follow from the key alone; then it does not matter who found it.
module adfric_numerics_found_once
   use adfric_base_kinds, only: dp, i8
   use adfric_numerics_thread_lock, only: thread_lock_t
   implicit none (type, external)
   private
   public :: found_once_t, search_t

   !> Numbers that belong to a key, at most.
   integer, parameter :: most_answers = 5
   !> Threads that seek at the same time and are waited for; what more of them find is not kept.
   integer, parameter :: most_seekers = 128
   !> Entries of a table that is used for the first time, and positions in which they are looked for.
   integer, parameter :: fewest_entries = 32, fewest_slots = 64
   !> Numbers of a long key that tell where it is looked for.
   integer, parameter :: most_sampled = 64

   !> A key and what belongs to it.
   type :: entry_t
      !> Where the key stands among `numbers`, before its first number, and its length; none: the key is looked up no more.
      integer :: before = 0, length = -1
      !> Number of the lock of the thread that seeks; 0: the numbers are known.
      integer :: seeker = 0
      !> The numbers.
      real(dp) :: answer(most_answers) = 0
   end type entry_t

   !> What a thread has been left to find.
   type :: search_t
      private
      !> Number of the entry and of the lock of the thread; 0: what is found is not kept.
      integer :: entry = 0, seeker = 0
      !> How often the table had begun anew.
      integer :: round = 0
   end type search_t

   !> Keys and what belongs to them.
   type :: found_once_t
      private
      !> Entries in the order in which they were asked for, the keys of all one behind the other, and the entry at each position
      !> where a key is looked for, 0 at a free one; not allocated before the first key.
      type(entry_t), allocatable :: entries(:)
      !> Numbers of the keys.
      real(dp), allocatable :: numbers(:)
      !> Entries by position.
      integer, allocatable :: slots(:)
      !> Entries and numbers in use, and how often the table has begun anew.
      integer :: n_entries = 0, n_numbers = 0, round = 0
      !> Does a thread hold the lock?
      logical :: is_locked(most_seekers) = .false.
      !> Locks of the threads that seek.
      type(thread_lock_t) :: locks(most_seekers)
      !> Keys, and numbers in them, beyond which the table begins anew; a single key may have more numbers.
      integer, public :: most_entries = 2**17, most_numbers = 2**22
      !> How often numbers were found, since they did not stand in the table.
      integer(i8), public :: n_found = 0
   contains
      procedure :: look_up
      procedure :: keep
      procedure :: give_up
      procedure :: clear
   end type found_once_t

contains

   !> Look up what belongs to a key; where another thread seeks it, once it has been found.
   subroutine look_up(self, key, answer, is_known, search)
      !> The table, which receives the key if it is not there.
      class(found_once_t), intent(inout) :: self
      !> The key, at least one number and no NaN.
      real(dp), intent(in) :: key(:)
      !> Receives the numbers if they are known; at most `most_answers`.
      real(dp), intent(inout) :: answer(:)
      !> Are they known? If not, the caller finds them, and calls `keep` or `give_up`.
      logical, intent(out) :: is_known
      !> Receives what these need.
      type(search_t), intent(out) :: search
      integer :: entry, lock

      do
         lock = 0
         !$omp critical (adfric_numerics_found_once)
         entry = entry_of(self, key)
         if (entry > 0) lock = self%entries(entry)%seeker
         is_known = entry > 0 .and. lock == 0
         if (is_known) answer = self%entries(entry)%answer(:size(answer))
         if (entry == 0) call begin_search(self, key, search)
         !$omp end critical (adfric_numerics_found_once)
         if (lock == 0) return
         call self%locks(lock)%wait_for()
      end do
   end subroutine look_up

   !> Keep what has been found, and let those who wait for it go on.
   subroutine keep(self, search, answer)
      class(found_once_t), intent(inout) :: self
      !> What `look_up` has given.
      type(search_t), intent(in) :: search
      !> The numbers.
      real(dp), intent(in) :: answer(:)

      !$omp critical (adfric_numerics_found_once)
      self%n_found = self%n_found + 1
      if (search%entry > 0 .and. search%round == self%round) then
         self%entries(search%entry)%answer(:size(answer)) = answer
         self%entries(search%entry)%seeker = 0
      end if
      call end_search(self, search)
      !$omp end critical (adfric_numerics_found_once)
   end subroutine keep

   !> Let those who wait seek for themselves: nothing could be found, for want of memory for example.
   subroutine give_up(self, search)
      class(found_once_t), intent(inout) :: self
      !> What `look_up` has given.
      type(search_t), intent(in) :: search

      !$omp critical (adfric_numerics_found_once)
      if (search%entry > 0 .and. search%round == self%round) self%entries(search%entry) = entry_t()
      call end_search(self, search)
      !$omp end critical (adfric_numerics_found_once)
   end subroutine give_up

   !> Forget everything, once no thread seeks or asks.
   subroutine clear(self)
      !> The table, which is empty at the end and holds no memory. It is called before a table ends.
      class(found_once_t), intent(inout) :: self
      integer :: k

      call begin_anew(self)
      if (allocated(self%entries)) deallocate (self%entries, self%numbers, self%slots)
      do k = 1, most_seekers
         call self%locks(k)%destroy()
      end do
   end subroutine clear

   !> Give back the lock of a thread that has sought.
   subroutine end_search(self, search)
      class(found_once_t), intent(inout) :: self
      !> What `look_up` has given.
      type(search_t), intent(in) :: search

      if (search%seeker == 0) return
      self%is_locked(search%seeker) = .false.
      call self%locks(search%seeker)%release()
   end subroutine end_search

   !> Let the thread that asks seek a key, which stands in the table from now on if there are space and a lock for it.
   subroutine begin_search(self, key, search)
      class(found_once_t), intent(inout) :: self
      real(dp), intent(in) :: key(:)
      !> Receives entry and lock; 0 where what is found is not kept.
      type(search_t), intent(inout) :: search
      integer :: failure, seeker

      seeker = findloc(self%is_locked, .false., dim=1)
      if (seeker == 0) return
      if (self%n_entries >= self%most_entries .or. size(key) > self%most_numbers - self%n_numbers) call begin_anew(self)
      call make_space(self, size(key), failure)
      if (failure /= 0) return
      self%numbers(self%n_numbers + 1:self%n_numbers + size(key)) = key
      self%n_entries = self%n_entries + 1
      self%entries(self%n_entries) = entry_t(before=self%n_numbers, length=size(key), seeker=seeker)
      self%n_numbers = self%n_numbers + size(key)
      self%slots(slot_of(self, key)) = self%n_entries
      search = search_t(entry=self%n_entries, seeker=seeker, round=self%round)
      self%is_locked(seeker) = .true.
      call self%locks(seeker)%acquire()
   end subroutine begin_search

   !> Forget all keys. Threads that seek go on, and what they find is not kept.
   pure subroutine begin_anew(self)
      class(found_once_t), intent(inout) :: self

      self%n_entries = 0
      self%n_numbers = 0
      self%round = self%round + 1
      if (allocated(self%slots)) self%slots = 0
   end subroutine begin_anew

   !> Make space for one more key: twice as much as there was, so that it is seldom made.
   pure subroutine make_space(self, length, failure)
      class(found_once_t), intent(inout) :: self
      integer, intent(in) :: length
      !> Receives 0, or another number if there is no memory.
      integer, intent(out) :: failure
      type(entry_t), allocatable :: entries(:)
      real(dp), allocatable :: numbers(:)
      integer, allocatable :: slots(:)

      failure = 0
      if (.not. allocated(self%entries)) then
         allocate (self%entries(fewest_entries), self%numbers(length), stat=failure)
         if (failure == 0) allocate (self%slots(fewest_slots), source=0, stat=failure)
         if (failure /= 0) call give_back(self)
         if (failure /= 0) return
      end if
      if (self%n_entries == size(self%entries)) then
         allocate (entries(2*self%n_entries), slots(4*self%n_entries), stat=failure)
         if (failure /= 0) return
         entries(:self%n_entries) = self%entries
         call move_alloc(entries, self%entries)
         call move_alloc(slots, self%slots)
         call fill_slots(self)
      end if
      if (self%n_numbers + length > size(self%numbers)) then
         allocate (numbers(max(2*self%n_numbers, self%n_numbers + length)), stat=failure)
         if (failure /= 0) return
         numbers(:self%n_numbers) = self%numbers(:self%n_numbers)
         call move_alloc(numbers, self%numbers)
      end if
   end subroutine make_space

   !> Give back what has been allocated of an empty table.
   pure subroutine give_back(self)
      class(found_once_t), intent(inout) :: self

      if (allocated(self%entries)) deallocate (self%entries)
      if (allocated(self%numbers)) deallocate (self%numbers)
      if (allocated(self%slots)) deallocate (self%slots)
   end subroutine give_back

   !> Set the positions of all entries anew.
   pure subroutine fill_slots(self)
      !> The table, more than half of whose positions stay free.
      class(found_once_t), intent(inout) :: self
      integer :: k, slot

      self%slots = 0
      do k = 1, self%n_entries
         associate (entry => self%entries(k))
            if (entry%length < 0) cycle
            slot = slot_of(self, self%numbers(entry%before + 1:entry%before + entry%length))
            self%slots(slot) = k
         end associate
      end do
   end subroutine fill_slots

   !> The entry of a key; 0 if it has none.
   pure integer function entry_of(self, key) result(entry)
      class(found_once_t), intent(in) :: self
      real(dp), intent(in) :: key(:)

      entry = 0
      if (allocated(self%slots)) entry = self%slots(slot_of(self, key))
   end function entry_of

   !> The position where a key stands, or the free one where it would.
   pure integer function slot_of(self, key) result(slot)
      class(found_once_t), intent(in) :: self
      real(dp), intent(in) :: key(:)

      slot = first_slot(key, size(self%slots))
      do while (self%slots(slot) > 0)
         if (is_key_of(self, self%entries(self%slots(slot)), key)) exit
         slot = 1 + modulo(slot, size(self%slots))
      end do
   end function slot_of

   !> Is a key that of an entry?
   pure logical function is_key_of(self, entry, key)
      class(found_once_t), intent(in) :: self
      type(entry_t), intent(in) :: entry
      real(dp), intent(in) :: key(:)
      integer :: i

      is_key_of = entry%length == size(key)
      if (.not. is_key_of) return
      do i = 1, size(key)
         is_key_of = .not. abs(self%numbers(entry%before + i) - key(i)) > 0
         if (.not. is_key_of) return
      end do
   end function is_key_of

   !> Where a key is looked for first: keys that differ in any bit of their sampled numbers are spread over all positions.
   pure integer function first_slot(key, n_slots) result(slot)
      real(dp), intent(in) :: key(:)
      integer, intent(in) :: n_slots
      !> The halves of a number are mixed by a multiplication modulo a prime, which does not overflow.
      integer(i8), parameter :: prime = 2147483647_i8, factor = 630360016_i8, half = 4294967295_i8
      integer(i8) :: bits, mixed
      integer :: i

      mixed = 1
      do i = 1, size(key), 1 + (size(key) - 1)/most_sampled
         ! -0 and 0 are one key, and their sums with 0 have the same bits
         bits = transfer(key(i) + 0.0_dp, bits)
         mixed = modulo(mixed*factor + iand(bits, half), prime)
         mixed = modulo(mixed*factor + ishft(bits, -32), prime)
      end do
      slot = 1 + int(modulo(mixed, int(n_slots, i8)))
   end function first_slot

end module adfric_numerics_found_once
