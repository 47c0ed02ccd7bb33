!> Which case it is: runs of one hash have the same results, bit by bit.
module adfric_run_case_hash
   use, intrinsic :: iso_fortran_env, only: compiler_version
   use adfric_base_kinds, only: dp
   use adfric_base_version, only: program_version, git_revision
   use adfric_model_model, only: model_t
   use adfric_run_plan, only: plan_t
   use adfric_system_checksum, only: checksum_t, checksum_length
   implicit none (type, external)
   private
   public :: case_hash

contains

   !> A hash of the program, the model, the value of every variable, the values of every axis and the checksum of every dataset.
   !> Names of files, title, comments and the form of the input do not count.
   function case_hash(model, plan) result(hash)
      !> The model, whose name and names of variables are hashed.
      class(model_t), intent(in) :: model
      !> The run, whose values, axes and checksums of datasets are hashed.
      type(plan_t), intent(in) :: plan
      character(checksum_length) :: hash
      type(checksum_t) :: sum
      integer :: i

      call sum%add_text(program_version)
      call sum%add_text(git_revision)
      call sum%add_text(compiler_version())
      call sum%add_text(model%name)
      do i = 1, size(model%variables)
         call sum%add_text(model%variables(i)%group)
         call sum%add_text(model%variables(i)%name)
         call sum%add_reals(plan%base(i:i))
      end do
      do i = 1, size(plan%axes)
         call sum%add_text(model%variables(plan%axes(i)%variable)%group)
         call sum%add_text(model%variables(plan%axes(i)%variable)%name)
         call sum%add_reals([real(size(plan%axes(i)%values), dp)])
         call sum%add_reals(plan%axes(i)%values)
      end do
      if (allocated(plan%sources)) then
         do i = 1, size(plan%sources)
            call sum%add_text(plan%sources(i)%checksum)
         end do
      end if
      hash = sum%to_text()
   end function case_hash

end module adfric_run_case_hash
