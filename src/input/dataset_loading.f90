!> The values of all datasets that an input names: from their files to the model.
module adfric_input_dataset_loading
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_input_case, only: case_t
   use adfric_input_dataset, only: load_dataset
   use adfric_input_variable, only: describe_allowed
   use adfric_model_model, only: model_t
   implicit none (type, external)
   private
   public :: load_datasets

contains

   !> Read every dataset and hand it to the model; what is wrong with one is said with its name and line.
   subroutine load_datasets(model, input, problems)
      !> The model, which takes over the values of each dataset.
      class(model_t), intent(inout) :: model
      !> In: the names of the datasets. Out: also what is known of their values, and which are broken.
      type(case_t), intent(inout) :: input
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      type(problems_t) :: found
      real(dp), allocatable :: values(:, :)
      character(:), allocatable :: flaw
      integer :: i, k

      do i = 1, size(input%datasets)
         if (input%is_broken(i) .or. .not. input%datasets(i)%is_given()) cycle
         associate (variable => model%variables(i), dataset => input%datasets(i))
            call load_dataset(dataset, variable, values, flaw)
            found = problems_t()
            if (len(flaw) > 0) then
               call found%add(variable%group, variable%name, flaw//', given '''//dataset%text//''', allowed: ' &
                  //describe_allowed(variable))
            else
               call model%take_dataset(i, values, found)
            end if
            do k = 1, found%count()
               call problems%add(found%items(k)%group, found%items(k)%variable, found%items(k)%text, line=input%line(i))
            end do
            input%is_broken(i) = found%count() > 0
            if (.not. input%is_broken(i)) input%values(i) = 1
         end associate
      end do
   end subroutine load_datasets

end module adfric_input_dataset_loading
