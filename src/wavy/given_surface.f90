!> What an input gives of a surface and its foundation beside single numbers: heights, waves, spectra.
module adfric_wavy_given_surface
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   implicit none (type, external)
   private
   public :: given_surface_t

   !> Lists and datasets of an input; what is not given is not allocated.
   type :: given_surface_t
      !> Heights [m]; shape `(nx, ny)`, a profile has one row.
      real(dp), allocatable :: heights(:, :)
      !> Distances of samples that the heights come with [m], or unset.
      real(dp) :: dx = unset, dy = unset
      !> Amplitudes [m] and phases [rad] of a sum of waves; shape `(n)`.
      real(dp), allocatable :: amplitudes(:), phases(:)
      !> Stiffnesses [Pa/m] and Young's moduli [Pa] of arms, and their relaxation times [s]; shape `(n)`.
      real(dp), allocatable :: moduli(:), young_moduli(:), relaxation_times(:)
      !> Angular frequency [rad/s], storage and loss modulus [Pa] of a master curve; shape `(n, 3)`.
      real(dp), allocatable :: master_curve(:, :)
      !> Temperature of the master curve [K], or unset.
      real(dp) :: master_temperature = unset
   end type given_surface_t

end module adfric_wavy_given_surface
