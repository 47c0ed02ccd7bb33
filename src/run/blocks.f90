! SPDX-License-Identifier: GPL-3.0-or-later
!> The blocks of a run: neighbouring points that are solved together, and how they are dealt out to the parts of a run.
!>
!> The size of a block depends on the model and the number of points alone, so that the results are the same whoever solves which
!> blocks, and in what order. A part of a run takes every so many stretches of blocks: neighbours cost about as much as
!> each other, and points far apart up to a thousand times as much, so parts of one piece would be done at very different
!> times. In each round of stretches every part gets one; whose turn is first changes every few rounds, lest a part meets
!> the same indices of the fastest axis again and again. (Every round would be worse: the dearest points of a sweep often
!> stand side by side, and are shared out evenly as long as the turns stay as they are.)
module adfric_run_blocks
   use adfric_base_kinds, only: i8
   implicit none (type, external)
   private
   public :: blocks_t, new_blocks, part_t, block_size_of

   !> Smallest and largest number of points of a block, and the number of blocks that a run between them has.
   integer, parameter :: smallest_block = 16, largest_block = 256, blocks_of_small_run = 32
   !> Number of stretches that a part of a large run has. More of them even out the cost of the parts, fewer are
   !> quicker to put together again.
   integer, parameter :: stretches_per_part = 64

   !> Number of rounds with the same turns.
   integer, parameter :: rounds_alike = 4

   !> One of the parts of a run.
   type :: part_t
      !> Number of the part, from 1.
      integer :: number = 1
      !> Number of parts.
      integer :: of = 1
      !> Has the part a file of its own, even if it is the only one?
      logical :: is_named = .false.
   contains
      procedure :: is_whole
   end type part_t

   !> The blocks of a part of a run. Blocks are numbered from 1 in the order of their points in the run; those of the part
   !> have indices from 1 in the same order.
   type :: blocks_t
      !> The part of the run; the whole run where nothing else is said.
      type(part_t) :: part
      !> Points and blocks of the whole run.
      integer(i8) :: n_points_of_run = 0, n_blocks_of_run = 0
      !> Points of a block, but for the last one of the run, which may have less.
      integer :: size = 1
      !> Blocks of a stretch, but for the last one of the run.
      integer(i8) :: stretch = 1
   contains
      procedure :: n_blocks
      procedure :: n_points
      procedure :: block_at
      procedure :: index_of
      procedure :: n_neighbours
      procedure :: first_point
      procedure :: n_points_of
      procedure :: row_of
      procedure, private :: turn_of
   end type blocks_t

contains

   !> The blocks of a part of a run.
   pure subroutine new_blocks(self, n_points, part, most)
      !> Receives the part, and how its run is cut into blocks and stretches.
      type(blocks_t), intent(out) :: self
      !> Number of points of the whole run.
      integer(i8), intent(in) :: n_points
      !> The part of the run; the whole run if absent.
      type(part_t), intent(in), optional :: part
      !> Largest number of points of a block, > 0; see `model_t%largest_block`.
      integer, intent(in), optional :: most

      if (present(part)) self%part = part
      self%size = block_size_of(n_points)
      if (present(most)) self%size = min(self%size, most)
      self%n_points_of_run = n_points
      self%n_blocks_of_run = (n_points + self%size - 1)/self%size
      self%stretch = max(1_i8, self%n_blocks_of_run/(int(stretches_per_part, i8)*self%part%of))
   end subroutine new_blocks

   !> Number of points of the blocks of a run.
   pure integer function block_size_of(n_points)
      !> Number of points of the whole run.
      integer(i8), intent(in) :: n_points

      block_size_of = int(min(int(largest_block, i8), max(int(smallest_block, i8), n_points/blocks_of_small_run)))
   end function block_size_of

   !> Is it the run as a whole, and not one of its parts?
   pure logical function is_whole(self)
      !> The part; one that is named has a file of its own.
      class(part_t), intent(in) :: self

      is_whole = .not. self%is_named
   end function is_whole

   !> Number of blocks of the part; 0 where there are more parts than blocks.
   pure integer(i8) function n_blocks(self)
      class(blocks_t), intent(in) :: self
      integer(i8) :: n_rounds, n_stretches, last

      n_stretches = (self%n_blocks_of_run + self%stretch - 1)/self%stretch
      n_rounds = n_stretches/self%part%of
      n_blocks = n_rounds*self%stretch
      if (self%turn_of(n_rounds) < n_stretches - n_rounds*self%part%of) n_blocks = n_blocks + self%stretch
      if (n_blocks == 0) return
      ! the last stretch of the run may be short
      last = self%block_at(n_blocks)
      if (last > self%n_blocks_of_run) n_blocks = n_blocks - (last - self%n_blocks_of_run)
   end function n_blocks

   !> Number of points of the part.
   pure integer(i8) function n_points(self)
      class(blocks_t), intent(in) :: self
      integer(i8) :: n

      n = self%n_blocks()
      n_points = n*self%size
      if (n > 0) n_points = n_points - (self%size - self%n_points_of(self%block_at(n)))
   end function n_points

   !> Which turn the part has in a round, from 0. The first turn goes round the parts by the golden section, which meets all
   !> of them evenly (Knuth, The Art of Computer Programming 3, 6.4).
   pure integer(i8) function turn_of(self, round)
      class(blocks_t), intent(in) :: self
      !> Number of the round, from 0.
      integer(i8), intent(in) :: round
      !> 2**32 times the golden section.
      integer(i8), parameter :: word = 2_i8**32, half_word = 2_i8**16, golden = 2654435769_i8
      integer(i8) :: share

      share = mod(mod(round/rounds_alike, half_word)*golden, word)/half_word
      turn_of = modulo(self%part%number - 1 - share*self%part%of/half_word, int(self%part%of, i8))
   end function turn_of

   !> Number of the block at a index of the part.
   pure integer(i8) function block_at(self, index)
      class(blocks_t), intent(in) :: self
      !> Index of the block in the part, from 1.
      integer(i8), intent(in) :: index
      integer(i8) :: round

      round = (index - 1)/self%stretch
      block_at = (round*self%part%of + self%turn_of(round))*self%stretch + mod(index - 1, self%stretch) + 1
   end function block_at

   !> Index of a block of the part.
   pure integer(i8) function index_of(self, block)
      class(blocks_t), intent(in) :: self
      !> Number of the block in the run, from 1; it must be one of the part.
      integer(i8), intent(in) :: block

      index_of = (block - 1)/(self%stretch*self%part%of)*self%stretch + mod(block - 1, self%stretch) + 1
   end function index_of

   !> How many blocks, from a index on, stand side by side in the run.
   pure integer(i8) function n_neighbours(self, index)
      class(blocks_t), intent(in) :: self
      !> Index of the block in the part, from 1.
      integer(i8), intent(in) :: index

      n_neighbours = self%n_blocks() - index + 1
      if (.not. self%part%is_whole()) n_neighbours = min(n_neighbours, self%stretch - mod(index - 1, self%stretch))
   end function n_neighbours

   !> Number of the first point of a block in the run, from 1.
   pure integer(i8) function first_point(self, block)
      class(blocks_t), intent(in) :: self
      !> Number of the block in the run, from 1.
      integer(i8), intent(in) :: block

      first_point = (block - 1)*self%size + 1
   end function first_point

   !> Number of points of a block.
   pure integer function n_points_of(self, block)
      class(blocks_t), intent(in) :: self
      !> Number of the block in the run, from 1.
      integer(i8), intent(in) :: block

      n_points_of = int(min(int(self%size, i8), self%n_points_of_run - (block - 1)*self%size))
   end function n_points_of

   !> Where a point of the run stands among the points of the part, from 1.
   pure integer(i8) function row_of(self, point)
      class(blocks_t), intent(in) :: self
      !> Number of the point in the run, from 1; it must be one of the part.
      integer(i8), intent(in) :: point

      row_of = (self%index_of((point - 1)/self%size + 1) - 1)*self%size + mod(point - 1, int(self%size, i8)) + 1
   end function row_of

end module adfric_run_blocks
