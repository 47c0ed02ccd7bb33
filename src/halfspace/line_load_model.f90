!> The models `line_load` and `strip_load`: given tractions on an elastic half-plane, plane strain.
module adfric_halfspace_line_load_model
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_model, only: result_t, variable_t
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_requirements, only: need
   use adfric_halfspace_field_model, only: field_model_t, set_stresses, set_displacements, maps_of
   use adfric_halfspace_flamant, only: line_stress, line_displacement
   use adfric_halfspace_halfspace_table, only: positive, number, choice, poisson_ratio_row
   use adfric_halfspace_strip_tractions, only: uniform_strip_stress, hertz_strip_stress, uniform_strip_integral, &
      & hertz_strip_integral
   implicit none (type, external)
   private
   public :: line_load_model_t, new_line_load_model, strip_load_model_t, new_strip_load_model

   !> Places of the variables; the last three are those of the line load, or of the strip load.
   integer, parameter, public :: v_young_modulus = 1, v_poisson_ratio = 2, v_x = 3, v_y = 4, v_normal = 5, v_tangential = 6, &
      & v_datum = 7, v_distribution = 7, v_half_width = 8
   !> Places of the results; a displacement is one of a line load, a slope one of a strip load.
   integer, parameter, public :: r_stress_xx = 1, r_stress_xy = 3, r_shear = 4, r_displacement_x = 5, r_displacement_y = 6, &
      & r_strain = 5, r_slope = 6
   integer, parameter, public :: distribution_uniform = 1, distribution_hertz = 2

   type, abstract, extends(field_model_t) :: plane_model_t
   contains
      procedure :: get_place => get_plane_place
   end type plane_model_t

   type, extends(plane_model_t) :: line_load_model_t
   contains
      procedure :: check_case => check_line
      procedure :: get_field => get_line_field
   end type line_load_model_t

   type, extends(plane_model_t) :: strip_load_model_t
   contains
      procedure :: check_case => check_strip
      procedure :: get_field => get_strip_field
   end type strip_load_model_t

contains

   !> The model of a line load with its tables.
   subroutine new_line_load_model(self)
      type(line_load_model_t), intent(out) :: self
      type(variable_t) :: v(7)
      type(result_t) :: r(6)

      call set_common(v)
      v(v_normal) = number('operating', 'normal_load', 'N/m', 'N per length, into the solid', 0.0_dp)
      v(v_tangential) = number('operating', 'tangential_load', 'N/m', 'T per length, along x', 0.0_dp)
      v(v_datum) = positive('operating', 'datum', 'm', 'distance that fixes the rigid motion of the displacements')
      v(v_datum)%default = 1
      call set_plane_stresses(r)
      call set_displacements('x y', r(r_displacement_x:))
      call self%set_tables('line_load', 'a line load on an elastic half-plane (Flamant): stresses and displacements', v, r, &
         & maps_of(r), 'y x', .true.)
   end subroutine new_line_load_model

   !> The model of a strip load with its tables.
   subroutine new_strip_load_model(self)
      type(strip_load_model_t), intent(out) :: self
      type(variable_t) :: v(8)
      type(result_t) :: r(6)

      call set_common(v)
      v(v_normal) = number('operating', 'normal_traction', 'Pa', 'p, into the solid; its largest value', 0.0_dp)
      v(v_tangential) = number('operating', 'tangential_traction', 'Pa', 'q, along x; its largest value', 0.0_dp)
      v(v_distribution) = choice('operating', 'distribution', 'of both tractions: constant, or sqrt(1 - x^2/a^2)', 'uniform hertz')
      v(v_half_width) = positive('operating', 'half_width', 'm', 'half-width a of the strip')
      call set_plane_stresses(r)
      r(r_strain) = result_t('surface_strain', '-', 'du_x/dx of the surface at position_x', '')
      r(r_slope) = result_t('surface_slope', '-', 'du_y/dx of the surface at position_x', '')
      call self%set_tables('strip_load', 'tractions on a strip of an elastic half-plane: stresses and surface slopes', v, r, &
         & maps_of(r), 'y x', .true.)
   end subroutine new_strip_load_model

   !> Rows that both have.
   subroutine set_common(v)
      type(variable_t), intent(inout) :: v(:)

      v(v_young_modulus) = positive('solid', 'young_modulus', 'Pa', 'Young''s modulus')
      v(v_poisson_ratio) = poisson_ratio_row()
      v(v_x) = number('position', 'position_x', 'm', 'where the results are, along the surface', 0.0_dp)
      v(v_y) = number('position', 'position_y', 'm', 'where the results are, depth', 0.0_dp)
      v(v_y)%lower = 0
   end subroutine set_common

   !> Rows of stresses.
   subroutine set_plane_stresses(r)
      type(result_t), intent(inout) :: r(:)

      call set_stresses('xx yy xy', r)
      r(r_shear) = result_t('largest_shear_stress', 'Pa', 'largest shear stress in the plane', '', .true.)
   end subroutine set_plane_stresses

   !> See `halfspace_model_t`.
   subroutine check_line(self, values, problems)
      class(line_load_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      call need(self%variables, values, [v_young_modulus, v_poisson_ratio], problems)
   end subroutine check_line

   !> See `halfspace_model_t`.
   subroutine check_strip(self, values, problems)
      class(strip_load_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      call need(self%variables, values, [v_young_modulus, v_poisson_ratio, v_distribution, v_half_width], problems)
   end subroutine check_strip

   !> See `field_model_t`.
   pure function get_plane_place(self, values, slow, fast) result(place)
      class(plane_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp), intent(in), optional :: slow, fast
      real(dp) :: place(3)

      place = [values(v_x), values(v_y), 0.0_dp]
      if (present(fast)) place(1) = fast
      if (present(slow)) place(2) = slow
      associate (unused => self)
      end associate
   end function get_plane_place

   !> See `field_model_t`.
   subroutine get_line_field(self, values, place, field)
      class(line_load_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp), intent(in) :: place(3)
      real(dp), intent(out) :: field(:)

      field = not_a_number()
      if (.not. maxval(abs(place)) > 0) return
      call set_stress(line_stress(values(v_normal), values(v_tangential), place(1), place(2)), field)
      field(r_displacement_x:r_displacement_y) = line_displacement(values(v_normal), values(v_tangential), &
         & values(v_young_modulus), values(v_poisson_ratio), values(v_datum), place(1), place(2))
      associate (unused => self)
      end associate
   end subroutine get_line_field

   !> See `field_model_t`. The slopes of the surface (Johnson 2.25), with p and q where they are and their principal values I:
   !>
   !>     du_x/dx = -(1 + nu)(1 - 2 nu)/E p - 2 (1 - nu^2)/(pi E) I[q]
   !>     du_y/dx =  (1 + nu)(1 - 2 nu)/E q - 2 (1 - nu^2)/(pi E) I[p]
   subroutine get_strip_field(self, values, place, field)
      class(strip_load_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp), intent(in) :: place(3)
      real(dp), intent(out) :: field(:)
      real(dp) :: x, y, shape, integral, near, far
      logical :: is_uniform

      x = place(1)/values(v_half_width)
      y = place(2)/values(v_half_width)
      is_uniform = nint(values(v_distribution)) == distribution_uniform
      field = not_a_number()
      ! a jump of the tractions: no values at the edges
      if (is_uniform .and. .not. max(abs(abs(x) - 1), y) > 0) return
      if (is_uniform) then
         call set_stress(uniform_strip_stress(values(v_normal), values(v_tangential), x, y), field)
         if (.not. abs(abs(x) - 1) > 0) return
         integral = uniform_strip_integral(x)
         shape = merge(1.0_dp, 0.0_dp, abs(x) < 1)
      else
         call set_stress(hertz_strip_stress(values(v_normal), values(v_tangential), x, y), field)
         integral = hertz_strip_integral(x)
         shape = sqrt(max(0.0_dp, (1 - x)*(1 + x)))
      end if
      near = (1 + values(v_poisson_ratio))*(1 - 2*values(v_poisson_ratio))/values(v_young_modulus)*shape
      far = 2*(1 - values(v_poisson_ratio)**2)/(pi*values(v_young_modulus))*integral
      field(r_strain) = -near*values(v_normal) - far*values(v_tangential)
      field(r_slope) = near*values(v_tangential) - far*values(v_normal)
      associate (unused => self)
      end associate
   end subroutine get_strip_field

   !> Stresses and their largest shear.
   pure subroutine set_stress(stress, field)
      real(dp), intent(in) :: stress(3)
      real(dp), intent(inout) :: field(:)

      field(r_stress_xx:r_stress_xy) = stress
      field(r_shear) = hypot((stress(1) - stress(2))/2, stress(3))
   end subroutine set_stress

end module adfric_halfspace_line_load_model
