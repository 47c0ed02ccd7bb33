!> Names of a results file, and whether it may be written.
module adfric_output_names
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_output_operating_system, only: kind_of_path, path_free, path_file, file_id_t, id_of_file, &
      is_same, is_locked
   implicit none (type, external)
   private
   public :: partial_name, check_output_name, would_replace

   !> What is added to the name of a file that is not complete.
   character(*), parameter :: partial_ending = '.partial'

contains

   !> Name of the file until it is complete.
   pure function partial_name(path) result(name)
      character(*), intent(in) :: path
      character(:), allocatable :: name

      name = path//partial_ending
   end function partial_name

   !> May a file of this name be written?
   subroutine check_output_name(path, overwrite, error)
      character(*), intent(in) :: path
      logical, intent(in) :: overwrite
      type(error_t), allocatable, intent(out) :: error

      select case (kind_of_path(path))
      case (path_free)
      case (path_file)
         if (.not. overwrite) call set_error(error, file_failure, &
            path//': this file exists; --force overwrites it, --output writes another one')
      case default
         call set_error(error, file_failure, path//': cannot write: this is no regular file')
      end select
      if (allocated(error)) return
      if (is_locked(partial_name(path))) call set_error(error, file_failure, &
         path//': another run is writing this file ('//partial_name(path)//' is in use)')
   end subroutine check_output_name

   !> Would results of this name replace a file, by whatever name it is called?
   logical function would_replace(path, file)
      !> Name of the results file.
      character(*), intent(in) :: path
      !> Name of the other file.
      character(*), intent(in) :: file
      type(file_id_t) :: id, id_of_final, id_of_partial

      id = id_of_file(file)
      id_of_final = id_of_file(path)
      id_of_partial = id_of_file(partial_name(path))
      would_replace = path == file .or. is_same(id, id_of_final) .or. is_same(id, id_of_partial)
   end function would_replace

end module adfric_output_names
