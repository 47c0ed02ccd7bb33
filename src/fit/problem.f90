! SPDX-License-Identifier: GPL-3.0-or-later
!> What is to be fitted: measured curves, events, and the variables of a model that are free.
!>
!> A measured curve is y_i = g M(x_i - x0; v) + y0 + s_i e_i with independent normal errors e_i of size 1. M is a result of the model
!> as a function of one of its variables, the abscissa; x0, y0, g and a spring are the nuisances of the curve. Which offset belongs to
!> what:
!>
!> - `load_offset` is the zero of the load: it is taken off an abscissa `load`, and added to an ordinate `load`.
!> - `contact_point` is the zero of the position: it is taken off an abscissa `approach`, and of a history off what is prescribed.
!> - `drift_rate` times the time is added to the approaches of a history.
!> - `friction_offset` is added to the ordinate, whatever that is.
!> - `lateral_gain` multiplies what the model says, not the offsets.
!> - `tilt` is the slope of the base line: times the abscissa as it was measured, it is added to an ordinate `load`.
!> - With a `spring_stiffness` k the abscissa `approach` is the position of the base of the spring, z = approach + P/k.
module adfric_fit_problem
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_describe_model, only: model_t
   implicit none (type, external)
   private
   public :: free_t, data_set_t, event_t, fit_t, copy_fit
   public :: n_nuisances, nuisance_load_offset, nuisance_friction_offset, nuisance_contact_point, nuisance_lateral_gain, &
      & nuisance_spring_stiffness, nuisance_tilt, nuisance_drift_rate, nuisance_names
   public :: loss_gauss, loss_huber, loss_soft_l1, loss_cauchy, loss_names
   public :: event_pull_off_load, event_jump_in_approach, event_pull_off_approach, event_names
   public :: intervals_covariance, intervals_profile, intervals_bootstrap, interval_names

   !> The nuisances of a data set, in the order of `nuisance_names`.
   integer, parameter :: nuisance_load_offset = 1, nuisance_friction_offset = 2, nuisance_contact_point = 3, &
      & nuisance_lateral_gain = 4, nuisance_spring_stiffness = 5, nuisance_tilt = 6, nuisance_drift_rate = 7, n_nuisances = 7
   character(*), parameter :: nuisance_names = 'load_offset friction_offset contact_point lateral_gain spring_stiffness tilt '// &
      & 'drift_rate'
   !> What a residual costs, in the order of `loss_names`.
   integer, parameter :: loss_gauss = 1, loss_huber = 2, loss_soft_l1 = 3, loss_cauchy = 4
   character(*), parameter :: loss_names = 'gauss huber soft_l1 cauchy'
   !> What may have been measured beside the points, in the order of `event_names`.
   integer, parameter :: event_pull_off_load = 1, event_jump_in_approach = 2, event_pull_off_approach = 3
   character(*), parameter :: event_names = 'pull_off_load jump_in_approach pull_off_approach'
   !> How intervals are found, in the order of `interval_names`.
   integer, parameter :: intervals_covariance = 1, intervals_profile = 2, intervals_bootstrap = 3
   character(*), parameter :: interval_names = 'covariance profile bootstrap'

   !> A free variable: one of the model, or a nuisance of a data set.
   type :: free_t
      !> Name, such as `lambda` or `data[2]%load_offset`.
      character(:), allocatable :: name
      !> SI unit, `-` for a pure number.
      character(:), allocatable :: unit
      !> Position in the model's table of variables; 0 for a nuisance.
      integer :: variable = 0
      !> Position of the list whose member is free, and which member that is, from 1; 0: it is none. `variable` is then that of the
      !> member in a model whose lists vary.
      integer :: list = 0, member = 0
      !> Number of the data set of a nuisance, and which one it is (`nuisance_...`); 0 for a variable of the model.
      integer :: data_set = 0, nuisance = 0
      !> Is ln v fitted, not v? Then v > 0.
      logical :: is_log = .true.
      !> Where the search starts; not set: from the data.
      real(dp) :: start = unset
      !> Bounds of the value. Not set: 0.01 and 100 for `lambda`, else those of the model's table, else none.
      real(dp) :: minimum = unset, maximum = unset
      !> What is known of the value beforehand, and its standard error: relative (of ln v) if `is_log`, else in the unit of v.
      real(dp) :: prior = unset, prior_sigma = unset
   end type free_t

   !> A measured curve.
   type :: data_set_t
      !> Name for messages, such as the file.
      character(:), allocatable :: name
      !> Position of the abscissa in the model's variables, and of the ordinate in its results.
      integer :: abscissa = 0, ordinate = 0
      !> Abscissa and ordinate, SI units; shape `(n_points)`.
      real(dp), allocatable :: x(:), y(:)
      !> Standard errors of the ordinate; not allocated: one for all points, which is not known.
      real(dp), allocatable :: sigma(:)
      !> Standard errors of the abscissa; not allocated: none.
      real(dp), allocatable :: x_sigma(:)
      !> Positions of further variables of the model that have a value for each point, and these values in SI units, shape
      !> `(n_others, n_points)`; not allocated: there are none.
      integer, allocatable :: others(:)
      !> See `others`.
      real(dp), allocatable :: at(:, :)
      !> Is the point one of contact? A free point's model is the base line. Not allocated: all are.
      logical, allocatable :: is_contact(:)
      !> Which part of the measurement the point belongs to; not allocated: one part. It sorts residuals for the runs test.
      integer, allocatable :: segment(:)
      !> What the history prescribes at the points, where the abscissa is the time [m or N]; not allocated elsewhere.
      real(dp), allocatable :: prescribed(:)
      !> Is the point used? Not allocated: all with finite numbers are.
      logical, allocatable :: is_used(:)
      !> One of `loss_...`, and its width in standard errors.
      integer :: loss = loss_gauss
      !> Width of the loss [standard errors]; not set: 1.345 (huber), 1 (soft_l1), 2.385 (cauchy).
      real(dp) :: loss_width = unset
      !> Values of the nuisances that are not free; `unset`: no spring.
      real(dp) :: nuisance(n_nuisances) = [0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, unset, 0.0_dp, 0.0_dp]
   end type data_set_t

   !> Something measured beside the points.
   type :: event_t
      !> Number of the data set whose nuisances shift it.
      integer :: data_set = 1
      !> One of `event_...`.
      integer :: kind = event_pull_off_load
      !> Measured value [N] or [m], and its standard error, > 0.
      real(dp) :: value = 0, sigma = 1
   end type event_t

   !> A fit: the model, the data, and what is asked for.
   type :: fit_t
      !> The model; nothing of it is changed.
      class(model_t), pointer :: model => null()
      !> Values of all variables of the model; those of free ones, of abscissas and of `others` have no meaning. Shape `(n_variables)`.
      real(dp), allocatable :: base(:)
      !> Free variables, shape `(n_free)`, at most 10.
      type(free_t), allocatable :: frees(:)
      !> Measured curves.
      type(data_set_t), allocatable :: data_sets(:)
      !> Positions of the times and of what is prescribed in the table of the model, where each curve of a stack has a history of
      !> its own; else 0.
      integer :: history_lists(2) = 0
      !> Events, size 0 if there is none.
      type(event_t), allocatable :: events(:)
      !> One of `intervals_...`.
      integer :: intervals = intervals_covariance
      !> Levels of the intervals, between 0 and 1.
      real(dp), allocatable :: levels(:)
      !> Most starts of the search; 0: as many as the variables ask for (`adfric_fit_starts`).
      integer :: n_starts = 0
      !> Theories to be compared, as positions in the choices of the model's variable `theory`; size 0: none.
      integer, allocatable :: theories(:)
      !> Names of derived quantities that are asked for, separated by blanks; empty: all that there are.
      character(:), allocatable :: derived
      !> Relative decrease of the sum of squares that ends a search.
      real(dp) :: relative_tolerance = 1.0e-10_dp
      !> Refits of the bootstrap, and the seed of its noise.
      integer :: n_bootstrap = 1000, seed = 1
      !> Are curves, bands, profiles and theories wanted beside the estimates? A stack leaves them out.
      logical :: wants_curves = .true.
   end type fit_t

contains

   !> Copy a fit: once for all, since each copy of so many parts takes a compiler long.
   subroutine copy_fit(from, to)
      !> What is copied.
      type(fit_t), intent(in) :: from
      !> Receives the copy.
      type(fit_t), intent(inout) :: to

      to = from
   end subroutine copy_fit

end module adfric_fit_problem
