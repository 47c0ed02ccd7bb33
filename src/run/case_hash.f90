! SPDX-License-Identifier: GPL-3.0-or-later
!> Which case it is: runs of one hash have the same results, bit by bit.
module adfric_run_case_hash
   use, intrinsic :: iso_fortran_env, only: compiler_version
   use adfric_base_kinds, only: dp
   use adfric_base_version, only: program_version, git_revision
   use adfric_run_run, only: run_t
   use adfric_run_variation, only: variation_t
   use adfric_system_checksum, only: checksum_t, checksum_length
   implicit none (type, external)
   private
   public :: case_hash

contains

   !> A hash of the program, the model, the value of every variable, the values of every axis, the checksum of every dataset and the
   !> digest of the rest.
   !> Names of files, title, comments and the form of the input do not count.
   function case_hash(run) result(hash)
      !> The run, with its model, values, axes and datasets.
      class(run_t), intent(in) :: run
      character(checksum_length) :: hash
      type(checksum_t) :: sum
      integer :: i, j

      call sum%add_text(program_version)
      call sum%add_text(git_revision)
      call sum%add_text(compiler_version())
      call sum%add_text(run%model%name)
      associate (variables => run%model%variables, axes => run%plan%axes)
         do i = 1, size(variables)
            call sum%add_text(variables(i)%group)
            call sum%add_text(variables(i)%name)
            call sum%add_reals(run%plan%base(i:i))
         end do
         do i = 1, size(axes)
            do j = 1, size(axes(i)%variables)
               call sum%add_text(variables(axes(i)%variables(j))%group)
               call sum%add_text(variables(axes(i)%variables(j))%name)
            end do
            call sum%add_reals([real(size(axes(i)%values, 2), dp)])
            do j = 1, size(axes(i)%variables)
               call sum%add_reals(axes(i)%values(j, :))
            end do
         end do
      end associate
      do i = 1, size(run%datasets)
         ! the values of an axis are in the hash already
         if (run%datasets(i)%is_given() .and. .not. run%plan%is_swept(i)) call sum%add_text(run%datasets(i)%checksum)
      end do
      if (allocated(run%digest)) call sum%add_text(run%digest)
      if (run%variation%is_wanted()) call add_variation(run%variation, sum)
      hash = sum%to_text()
   end function case_hash

   !> Add what is wanted beside the results.
   subroutine add_variation(wanted, sum)
      type(variation_t), intent(in) :: wanted
      type(checksum_t), intent(inout) :: sum
      integer :: i

      call sum%add_text('variation')
      call sum%add_reals(real(wanted%derivatives, dp))
      do i = 1, size(wanted%uncertain)
         call sum%add_reals([real(wanted%uncertain(i)%variable, dp), wanted%uncertain(i)%error, wanted%uncertain(i)%relative_error])
      end do
      call sum%add_reals(real([wanted%n_samples, wanted%seed], dp))
   end subroutine add_variation

end module adfric_run_case_hash
