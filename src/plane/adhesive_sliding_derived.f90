! SPDX-License-Identifier: GPL-3.0-or-later
!> What `check` derives of the edges of a wave or a cylinder that adheres while it slides.
module adfric_plane_adhesive_sliding_derived
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_describe_derived, only: add_derived, derived_t
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t
   use adfric_plane_crack_works, only: crack_works_t, get_crack_works
   implicit none (type, external)
   private
   public :: derive_edges

contains

   !> Add order of states, zone and works of the two edges.
   subroutine derive_edges(list, slide, order_margin, length, stress, range)
      type(derived_t), allocatable, intent(inout) :: list(:)
      !> The reduced wave or cylinder.
      type(adhesive_slide_t), intent(in) :: slide
      !> Order of its states [-].
      real(dp), intent(in) :: order_margin
      !> Unit of length of the reduced one [m].
      real(dp), intent(in) :: length
      !> Stress [Pa] and range [m] of the adhesion.
      real(dp), intent(in) :: stress, range
      type(crack_works_t) :: works
      logical :: is_converged
      real(dp) :: zone

      zone = pi*slide%range/(4*slide%stress)
      call add_derived(list, 'margin_of_order', '-', 'order M/Einf; where >= 0 the branches bound all states', order_margin)
      call add_derived(list, 'zone_length', 'm', 'length of a short zone of adhesion at rest, pi E0 d0/(4 p0)', &
         & zone*length)
      if (slide%solid%n_arms == 0) return
      call get_crack_works(slide%compliances, slide%solid%retardation/zone, works, is_converged)
      if (.not. is_converged) return
      call add_derived(list, 'opening_work', 'J/m^2', 'work that opens a short zone behind the contact', &
         & works%opening*stress*range)
      call add_derived(list, 'closing_work', 'J/m^2', 'work that a closing short zone gives back ahead of it', &
         & works%closing*stress*range)
   end subroutine derive_edges

end module adfric_plane_adhesive_sliding_derived
