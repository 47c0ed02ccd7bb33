! SPDX-License-Identifier: GPL-3.0-or-later
!> The rules by which a scene has names for what its solver has in a language of its own.
!>
!> Each solver has names of its own; here stands what they are in the one language of scenes. A rule has
!>
!> - the solvers that it is for, separated by a comma, or `*`;
!> - the name in the language of the solver; where it has no meaning there may be several, separated by a comma;
!> - the name in the language of scenes, or `-` where it has no meaning;
!> - the facts of a scene that the rule needs (`adfric_describe_scene_facts`), `!` before one that must be absent.
!>
!> The first rule that holds counts. What no rule names is called the same in both languages. The file is long by its rules.
module adfric_describe_scene_rules
   implicit none (type, external)
   private
   public :: hidden, with_depth, variable_rules, result_rules, profile_rules, word_rules, meanings, default_rules
   public :: added_words, of_speed, along_motion, phrases

   !> Stands in a rule for the name of what has no meaning in a scene.
   character(*), parameter :: hidden = '-'
   !> Solvers that several rules have in common.
   character(*), parameter :: on_cells = 'wave_1d_elastic,wave_2d_elastic,surface_elastic,spectrum_elastic'
   character(*), parameter :: in_elastic = 'hertz,wave_1d', two_solids = 'hertz,wave_1d,rough_theories', &
      & slips = 'hertz,indenter,wave_1d,'//on_cells, with_depth = 'rigid_punch,line_load,strip_load', &
      & periodic = 'wave_1d,'//on_cells, round = 'sphere,indenter', &
      & sums = 'hertz,adhesive_cylinder,wave_1d,wavy_sliding,surface_sliding', heats = 'hertz,indenter,surface_sliding'

   !> Solvers of contacts that shear stress may move.
   character(*), parameter :: couples = 'hertz,wave_1d,surface_sliding,rigid_punch'

   !> Variables. A group stands for all its variables that no rule before it names.
   character(*), parameter :: variable_rules(*) = [character(160) :: &
      & 'rough_theories operating%velocity,operating%temperature - !relaxing', &
      & 'rough_theories adhesion% - relaxing', &
      & 'spectrum_elastic estimates%yang_persson_constant - !by_yang_persson', &
      & on_cells//' layer%base - !layer', &
      & on_cells//' layer%base_young_modulus,layer%base_poisson_ratio - !coating', &
      & on_cells//' layer%thickness - !layer !coating', &
      & on_cells//' layer% solid%', &
      & on_cells//' operating%penetration operating%approach layer', &
      & 'wavy_sliding surface%slope surface%slope_approximation', &
      & 'wavy_sliding surface%height surface%amplitude', &
      & 'wavy_sliding surface%spacing surface%length_x', &
      & 'wavy_sliding surface%strip_spacing surface%length_y', &
      & 'wavy_sliding surface%blend_share surface%blend_fraction', &
      & 'wavy_sliding surface%reverse operating%direction', &
      & 'wavy_sliding foundation%moduli solid%stiffnesses', &
      & 'wavy_sliding foundation% solid%', &
      & 'wavy_sliding operating%penetration operating%approach', &
      & 'surface_sliding operating%penetration operating%approach layer', &
      & 'surface_sliding surface%direction operating%direction', &
      & 'surface_sliding material%poisson_ratio - !young', &
      & 'surface_sliding layer%poisson_ratio - young', &
      & 'surface_sliding layer%poisson_ratio - !layer', &
      & 'surface_sliding layer% solid%', &
      & two_solids//' solid%contact_modulus,solid%young_modulus,solid%poisson_ratio,solid%second_young_modulus - relaxing', &
      & two_solids//' solid%second_poisson_ratio - relaxing', &
      & in_elastic//' friction%coupling - relaxing coupled', &
      & two_solids//' material% - !relaxing', &
      & 'hertz operating%state - !rolls', &
      & 'hertz operating%creepage - !rolls !coulomb', &
      & 'hertz operating%state,operating%creepage,operating%contact_half_width - relaxing', &
      & 'hertz operating%contact_half_width - cylinder !coulomb !shear', &
      & 'hertz operating%contact_half_width operating%major_half_width ellipsoid', &
      & 'hertz operating%contact_half_width operating%contact_radius paraboloid', &
      & two_solids//' material%poisson_ratio - contact_curve', &
      & '* material% solid%', &
      & '* adhesion%surface_energy adhesion%work_of_adhesion', &
      & '* adhesion%stress adhesion%adhesion_stress', &
      & '* adhesion%range adhesion%adhesion_range', &
      & '* adhesion%branch operating%branch', &
      & '* adhesion%turning_pressure operating%turning_pressure', &
      & '* adhesion%turning_load operating%turning_load', &
      & 'sphere sphere%poisson_ratio - !young', &
      & 'sphere friction%poisson_ratio - young', &
      & 'sphere friction%poisson_ratio,output%events - !shear', &
      & 'sphere sphere%second_young_modulus,sphere%second_poisson_ratio - shear', &
      & 'sphere friction%poisson_ratio solid%poisson_ratio', &
      & 'sphere sphere%units job%units', &
      & 'sphere sphere%radius surface%radius', &
      & 'sphere sphere%work_of_adhesion - !adhesion', &
      & 'sphere sphere%work_of_adhesion adhesion%work_of_adhesion', &
      & 'sphere sphere%adhesion_stress adhesion%adhesion_stress', &
      & 'sphere sphere%adhesion_range adhesion%adhesion_range', &
      & 'sphere sphere%lambda adhesion%lambda', &
      & 'sphere sphere% solid%', &
      & 'sphere numerics%relative_tolerance adhesion%theory_tolerance', &
      & '* model%theory adhesion%theory', &
      & '* friction%coefficient friction%coulomb_coefficient', &
      & '* contact% surface%', &
      & '* punch%half_width surface%face_half_width', &
      & '* punch% surface%', &
      & '* shape%coefficient surface%power_coefficient', &
      & '* shape% surface%', &
      & '* operating%tangential_axis operating%direction', &
      & 'rigid_punch numerics%points numerics%collocation_points', &
      & on_cells//',surface_sliding,surface_time numerics%relative_tolerance numerics%contact_tolerance', &
      & with_depth//' output%y_min output%z_min', &
      & with_depth//' output%y_max output%z_max', &
      & with_depth//' output%n_y output%n_z', &
      & 'line_load,strip_load position%position_y position%position_z', &
      & 'line_load operating%datum traction%datum', &
      & 'line_load,point_load operating%normal_load operating%load', &
      & 'line_load,point_load operating%tangential_load operating%tangential_force', &
      & 'strip_load operating%normal_traction traction%pressure', &
      & 'strip_load operating%tangential_traction traction%shear_stress', &
      & 'strip_load samples%shear_tractions traction%shear_stresses', &
      & 'strip_load samples% traction%', &
      & 'strip_load,rectangle_load operating% traction%']

   !> Results of surfaces known by their spectrum.
   character(*), parameter :: spectrum_rules(*) = [character(160) :: &
      & 'rough_theories contact_fraction_persson,mean_square_pressure_persson - adhesion', &
      & 'rough_theories contact_fraction_yang_persson,contact_fraction_wang_mueser - adhesion', &
      & 'rough_theories contact_fraction_greenwood_williamson,contact_fraction_bush_gibson_thomas - adhesion', &
      & 'rough_theories contact_fraction_greenwood_elliptic,contact_fraction_nayak_sphere - adhesion', &
      & 'rough_theories contact_fraction_yang_persson,contact_fraction_wang_mueser - relaxing', &
      & 'rough_theories contact_fraction_greenwood_williamson,contact_fraction_bush_gibson_thomas - relaxing', &
      & 'rough_theories contact_fraction_greenwood_elliptic,contact_fraction_nayak_sphere - relaxing', &
      & 'rough_theories mean_gap_persson,mean_gap_yang_persson,mean_gap_wang_mueser,mean_gap_greenwood_williamson - adhesion', &
      & 'rough_theories mean_gap_bush_gibson_thomas,mean_gap_greenwood_elliptic,mean_gap_nayak_sphere - adhesion', &
      & 'rough_theories mean_gap_persson,mean_gap_yang_persson,mean_gap_wang_mueser,mean_gap_greenwood_williamson - relaxing', &
      & 'rough_theories mean_gap_bush_gibson_thomas,mean_gap_greenwood_elliptic,mean_gap_nayak_sphere - relaxing', &
      & 'rough_theories normal_stiffness_persson,normal_stiffness_yang_persson,normal_stiffness_wang_mueser - adhesion', &
      & 'rough_theories normal_stiffness_greenwood_williamson - adhesion', &
      & 'rough_theories normal_stiffness_bush_gibson_thomas,normal_stiffness_greenwood_elliptic - adhesion', &
      & 'rough_theories normal_stiffness_nayak_sphere - adhesion', &
      & 'rough_theories normal_stiffness_persson,normal_stiffness_yang_persson,normal_stiffness_wang_mueser - relaxing', &
      & 'rough_theories normal_stiffness_greenwood_williamson - relaxing', &
      & 'rough_theories normal_stiffness_bush_gibson_thomas,normal_stiffness_greenwood_elliptic - relaxing', &
      & 'rough_theories normal_stiffness_nayak_sphere - relaxing', &
      & 'rough_theories conductance_factor_persson,conductance_factor_yang_persson,conductance_factor_wang_mueser - adhesion', &
      & 'rough_theories conductance_factor_greenwood_williamson - adhesion', &
      & 'rough_theories conductance_factor_bush_gibson_thomas,conductance_factor_greenwood_elliptic - adhesion', &
      & 'rough_theories conductance_factor_nayak_sphere - adhesion', &
      & 'rough_theories conductance_factor_persson,conductance_factor_yang_persson,conductance_factor_wang_mueser - relaxing', &
      & 'rough_theories conductance_factor_greenwood_williamson - relaxing', &
      & 'rough_theories conductance_factor_bush_gibson_thomas,conductance_factor_greenwood_elliptic - relaxing', &
      & 'rough_theories conductance_factor_nayak_sphere - relaxing', &
      & 'rough_theories elastic_energy_persson,elastic_energy_yang_persson,elastic_energy_wang_mueser - adhesion', &
      & 'rough_theories elastic_energy_persson,elastic_energy_yang_persson,elastic_energy_wang_mueser - relaxing', &
      & 'rough_theories mean_square_pressure_persson - relaxing', &
      & 'rough_theories pull_off_pressure_yang_persson,pull_off_pressure_wang_mueser,pull_off_gap_yang_persson - !adhesion', &
      & 'rough_theories pull_off_gap_wang_mueser - !adhesion', &
      & 'rough_theories pastewka_robbins_ratio,full_contact_work_ratio - !adhesion', &
      & 'rough_theories friction_coefficient_persson,friction_coefficient_yang_persson - !relaxing', &
      & 'rough_theories friction_coefficient_wang_mueser,full_contact_friction_coefficient - !relaxing', &
      & 'spectrum_elastic mean_pressure_spread,mean_pressure_error_of_mean,penetration_spread - !ensemble', &
      & 'spectrum_elastic penetration_error_of_mean,contact_fraction_spread,contact_fraction_error_of_mean - !ensemble', &
      & 'spectrum_elastic peak_pressure_spread,peak_pressure_error_of_mean,mean_gap_spread - !ensemble', &
      & 'spectrum_elastic mean_gap_error_of_mean,elastic_energy_spread,elastic_energy_error_of_mean - !ensemble', &
      & 'spectrum_elastic pull_off_pressure_spread,pull_off_pressure_error_of_mean,friction_stress_spread - !ensemble', &
      & 'spectrum_elastic friction_stress_error_of_mean,friction_coefficient_spread - !ensemble', &
      & 'spectrum_elastic friction_coefficient_error_of_mean,stick_fraction_spread - !ensemble', &
      & 'spectrum_elastic stick_fraction_error_of_mean,tangential_displacement_spread - !ensemble', &
      & 'spectrum_elastic tangential_displacement_error_of_mean,tangential_stiffness_spread - !ensemble', &
      & 'spectrum_elastic tangential_stiffness_error_of_mean - !ensemble', &
      & 'spectrum_elastic regime - ensemble', &
      & 'spectrum_elastic mean_pressure_spread,mean_pressure_error_of_mean - pressure_given', &
      & 'spectrum_elastic penetration_spread,penetration_error_of_mean - !pressure_given', &
      & 'spectrum_elastic penetration_spread approach_spread layer', &
      & 'spectrum_elastic penetration_error_of_mean approach_error_of_mean layer', &
      & 'spectrum_elastic pull_off_pressure_spread,pull_off_pressure_error_of_mean - !pull_off', &
      & 'spectrum_elastic friction_stress_spread,friction_stress_error_of_mean,friction_coefficient_spread - !interface', &
      & 'spectrum_elastic friction_coefficient_error_of_mean - !interface', &
      & 'spectrum_elastic stick_fraction_spread,stick_fraction_error_of_mean,tangential_displacement_spread - !tangential', &
      & 'spectrum_elastic tangential_displacement_error_of_mean,tangential_stiffness_spread - !tangential', &
      & 'spectrum_elastic tangential_stiffness_error_of_mean - !tangential', &
      & 'spectrum_elastic stick_fraction_spread,stick_fraction_error_of_mean,tangential_displacement_spread - slides', &
      & 'spectrum_elastic tangential_displacement_error_of_mean,tangential_stiffness_spread - slides', &
      & 'spectrum_elastic tangential_stiffness_error_of_mean - slides', &
      & 'spectrum_elastic contact_fraction_persson,mean_gap_persson,normal_stiffness_persson - !by_persson', &
      & 'spectrum_elastic conductance_factor_persson,elastic_energy_persson,mean_square_pressure_persson - !by_persson', &
      & 'spectrum_elastic contact_fraction_yang_persson,mean_gap_yang_persson - !by_yang_persson', &
      & 'spectrum_elastic normal_stiffness_yang_persson,conductance_factor_yang_persson - !by_yang_persson', &
      & 'spectrum_elastic elastic_energy_yang_persson - !by_yang_persson', &
      & 'spectrum_elastic contact_fraction_wang_mueser,mean_gap_wang_mueser - !by_wang_mueser', &
      & 'spectrum_elastic normal_stiffness_wang_mueser,conductance_factor_wang_mueser - !by_wang_mueser', &
      & 'spectrum_elastic elastic_energy_wang_mueser - !by_wang_mueser', &
      & 'spectrum_elastic contact_fraction_greenwood_williamson,mean_gap_greenwood_williamson - !by_greenwood_williamson', &
      & 'spectrum_elastic normal_stiffness_greenwood_williamson - !by_greenwood_williamson', &
      & 'spectrum_elastic conductance_factor_greenwood_williamson - !by_greenwood_williamson', &
      & 'spectrum_elastic contact_fraction_bush_gibson_thomas,mean_gap_bush_gibson_thomas - !by_bush_gibson_thomas', &
      & 'spectrum_elastic normal_stiffness_bush_gibson_thomas - !by_bush_gibson_thomas', &
      & 'spectrum_elastic conductance_factor_bush_gibson_thomas - !by_bush_gibson_thomas', &
      & 'spectrum_elastic contact_fraction_greenwood_elliptic,mean_gap_greenwood_elliptic - !by_greenwood_elliptic', &
      & 'spectrum_elastic normal_stiffness_greenwood_elliptic - !by_greenwood_elliptic', &
      & 'spectrum_elastic conductance_factor_greenwood_elliptic - !by_greenwood_elliptic', &
      & 'spectrum_elastic contact_fraction_nayak_sphere,mean_gap_nayak_sphere - !by_nayak_sphere', &
      & 'spectrum_elastic normal_stiffness_nayak_sphere,conductance_factor_nayak_sphere - !by_nayak_sphere', &
      & 'spectrum_elastic electrical_conductance_persson,thermal_conductance_persson - !by_persson', &
      & 'spectrum_elastic electrical_conductance_yang_persson,thermal_conductance_yang_persson - !by_yang_persson', &
      & 'spectrum_elastic electrical_conductance_wang_mueser,thermal_conductance_wang_mueser - !by_wang_mueser', &
      & 'spectrum_elastic electrical_conductance_greenwood_williamson - !by_greenwood_williamson', &
      & 'spectrum_elastic thermal_conductance_greenwood_williamson - !by_greenwood_williamson', &
      & 'spectrum_elastic electrical_conductance_bush_gibson_thomas - !by_bush_gibson_thomas', &
      & 'spectrum_elastic thermal_conductance_bush_gibson_thomas - !by_bush_gibson_thomas', &
      & 'spectrum_elastic electrical_conductance_greenwood_elliptic - !by_greenwood_elliptic', &
      & 'spectrum_elastic thermal_conductance_greenwood_elliptic - !by_greenwood_elliptic', &
      & 'spectrum_elastic electrical_conductance_nayak_sphere,thermal_conductance_nayak_sphere - !by_nayak_sphere', &
      & 'spectrum_elastic electrical_conductance_persson,electrical_conductance_yang_persson - !electrical', &
      & 'spectrum_elastic electrical_conductance_wang_mueser - !electrical', &
      & 'spectrum_elastic electrical_conductance_greenwood_williamson - !electrical', &
      & 'spectrum_elastic electrical_conductance_bush_gibson_thomas - !electrical', &
      & 'spectrum_elastic electrical_conductance_greenwood_elliptic - !electrical', &
      & 'spectrum_elastic electrical_conductance_nayak_sphere - !electrical', &
      & 'spectrum_elastic thermal_conductance_persson,thermal_conductance_yang_persson - !thermal', &
      & 'spectrum_elastic thermal_conductance_wang_mueser,thermal_conductance_greenwood_williamson - !thermal', &
      & 'spectrum_elastic thermal_conductance_bush_gibson_thomas,thermal_conductance_greenwood_elliptic - !thermal', &
      & 'spectrum_elastic thermal_conductance_nayak_sphere - !thermal', &
      & 'rough_theories electrical_conductance_persson,electrical_conductance_yang_persson - !electrical', &
      & 'rough_theories electrical_conductance_wang_mueser,electrical_conductance_greenwood_williamson - !electrical', &
      & 'rough_theories electrical_conductance_bush_gibson_thomas,electrical_conductance_greenwood_elliptic - !electrical', &
      & 'rough_theories electrical_conductance_nayak_sphere - !electrical', &
      & 'rough_theories thermal_conductance_persson,thermal_conductance_yang_persson - !thermal', &
      & 'rough_theories thermal_conductance_wang_mueser,thermal_conductance_greenwood_williamson - !thermal', &
      & 'rough_theories thermal_conductance_bush_gibson_thomas,thermal_conductance_greenwood_elliptic - !thermal', &
      & 'rough_theories thermal_conductance_nayak_sphere - !thermal']

   !> Those of all others.
   character(*), parameter :: other_rules(*) = [character(160) :: &
      & '* electrical_conductance - !electrical', &
      & '* thermal_conductance - !thermal', &
      & on_cells//',free_surface contact_stiffness - !stiffness_wanted', &
      & on_cells//',free_surface stiffness_error - !stiffness_wanted !electrical !thermal', &
      & on_cells//' plastic_fraction,mean_plastic_depth,plastic_work - !plastic', &
      & 'sphere contact_stiffness - shear', &
      & 'hertz contact_stiffness - cylinder', &
      & 'wave_1d contact_stiffness - adhesion', &
      & 'wave_1d contact_stiffness - relaxing', &
      & 'wave_1d contact_stiffness - coupled', &
      & 'wavy_sliding friction_force friction_stress', &
      & 'wavy_sliding load mean_pressure', &
      & 'wavy_sliding contact_area contact_fraction', &
      & 'wavy_sliding adhesion_area,adhesion_count,edge_loss,pull_off_load,pull_off_penetration - !adhesion', &
      & 'wavy_sliding adhesion_area adhesion_fraction', &
      & 'wavy_sliding penetration approach', &
      & 'wavy_sliding pull_off_load pull_off_pressure', &
      & 'wavy_sliding pull_off_penetration pull_off_approach', &
      & 'wavy_sliding contact_count,adhesion_count,snap_count,saturated_share - wave_product', &
      & 'wavy_sliding saturated_share full_contact_fraction_of_strips', &
      & 'wavy_sliding friction_sample_error - !heights', &
      & 'wavy_sliding friction_sample_error friction_standard_error', &
      & 'wavy_sliding contact_width crest_contact_width wave_product', &
      & on_cells//',surface_sliding penetration approach layer', &
      & 'surface_sliding lateral_stress lateral_friction_stress', &
      & 'surface_sliding full_contact_friction full_contact_friction_stress', &
      & 'surface_sliding adhesion_fraction,cells_per_zone,order_margin,friction_stress_without_adhesion - !adhesion', &
      & 'surface_sliding adhesive_friction_stress - !adhesion', &
      & 'indenter full_stick_stiffness,full_stick_load,full_stick_approach - !may_stick', &
      & 'indenter full_stick_load,full_stick_approach - !of_one_power', &
      & 'indenter slip,largest_slip,stick_radius - coulomb', &
      & round//' slip,largest_slip,stick_radius,sliding_force - slides', &
      & round//' slip,largest_slip,stick_radius - !tangential', &
      & round//' slip edge_slip', &
      & round//' largest_slip largest_edge_slip', &
      & round//' adhesion_ratio,adhesion_radius,pull_off_load,theory_used - !adhesion', &
      & round//' adhesion_ratio,friction_radius,friction_area - !shear', &
      & 'indenter pull_off_approach,jump_inward_load,jump_inward_approach,jump_outward_load,jump_outward_approach - !adhesion', &
      & 'indenter loop_energy - !adhesion', &
      & 'indenter loop_energy,jump_in_load - !events', &
      & 'indenter loop_energy adhesion_hysteresis', &
      & 'indenter jump_in_base_approach,pull_off_base_approach,base_approach - !machine', &
      & 'indenter stress_zz,stress_rr - !position', &
      & 'attracted_indenter base_approach - !machine', &
      & 'sphere theory_error - !adhesion', &
      & 'indenter_time storage_modulus,loss_modulus - !oscillates', &
      & 'adhesive_indenter_time storage_modulus,loss_modulus -', &
      & round//' peak_force,peak_displacement,sliding_force,force_drop,snap_off_force,snap_off_displacement - !lateral', &
      & round//' peak_force peak_tangential_force', &
      & round//' peak_displacement peak_tangential_displacement', &
      & 'sphere friction_force friction_force slides', &
      & 'sphere friction_force - !tangential', &
      & 'sphere friction_force tangential_force', &
      & 'indenter friction_force friction_force slides', &
      & 'indenter friction_force -', &
      & 'indenter tangential_force - moves', &
      & 'indenter tangential_force - !driven', &
      & 'indenter velocity_slope - !moves', &
      & round//' sliding_force friction_force', &
      & round//' force_drop tangential_force_drop', &
      & round//' snap_off_force,snap_off_displacement - !peels', &
      & round//' snap_off_force snap_off_tangential_force', &
      & round//' snap_off_displacement snap_off_tangential_displacement', &
      & round//' critical_lateral_stiffness - !lateral', &
      & round//' jump_base_displacement,jump_displacement,jump_force,arrest_force,jump_energy,jump_period - !spring', &
      & round//' jump_base_displacement stick_slip_base_displacement', &
      & round//' jump_displacement stick_slip_displacement', &
      & round//' jump_force stick_slip_force', &
      & round//' jump_energy stick_slip_energy', &
      & round//' jump_period stick_slip_period', &
      & round//' period_work - !spring', &
      & round//' period_work stick_slip_work', &
      & 'hertz tangential_displacement,tangential_stiffness - cylinder', &
      & round//',hertz,'//periodic//' tangential_displacement - !tangential', &
      & 'hertz tangential_force,creepage,stick_fraction - relaxing', &
      & 'hertz stick_fraction stick_fraction rolls', &
      & 'hertz dissipation dissipation rolls', &
      & 'hertz energy_imbalance energy_imbalance rolls', &
      & 'hertz tangential_force,creepage - !rolls', &
      & 'hertz cycle_energy - rolls', &
      & slips//' tangential_displacement,stick_fraction,cycle_energy - slides', &
      & slips//' stick_fraction,tangential_stiffness,cycle_energy - !tangential', &
      & slips//' tangential_stiffness - slides', &
      & slips//' cycle_energy friction_loss_per_cycle', &
      & 'rigid_punch,indenter,hertz mean_pressure mean_contact_pressure', &
      & 'rigid_punch edge_intensity - !face', &
      & 'rigid_punch centre_pressure - wedge', &
      & 'rigid_punch edge_intensity edge_intensity_factor', &
      & 'hertz approach,contact_area - cylinder', &
      & 'hertz minor_half_width,major_axis_angle - !ellipsoid', &
      & 'hertz contact_half_width contact_radius paraboloid', &
      & 'hertz contact_half_width major_half_width ellipsoid', &
      & 'hertz friction_force,friction_coefficient - !slides', &
      & 'hertz contact_shift,energy_imbalance - ellipsoid', &
      & 'rigid_punch friction_force,friction_coefficient - !slides', &
      & 'rigid_punch contact_shift,energy_imbalance - !coupled', &
      & 'rigid_punch hysteretic_friction_force,interfacial_friction_force,interfacial_share - !shear', &
      & 'rigid_punch velocity_slope -', &
      & 'rigid_punch contact_violation,edge_intensity - coupled', &
      & 'hertz,wave_1d contact_shift,energy_imbalance - !slides', &
      & 'wave_1d dissipation - !slides', &
      & 'wave_1d dissipation - coupled', &
      & 'hertz dissipation - !relaxing', &
      & 'surface_sliding dissipation - coupled layer', &
      & 'hertz largest_shear_stress,largest_shear_depth - slides', &
      & 'hertz largest_shear_stress,largest_shear_depth - rolls', &
      & 'hertz_history major_axis_angle,axis_ratio - !ellipsoid', &
      & 'wave_1d adhesion_fraction,pull_off_penetration,jump_off_penetration,saturation_fold_pressure,order_margin - !adhesion', &
      & 'wave_1d adhesion_energy,pull_off_penetration,jump_off_penetration,hysteresis_loss - relaxing', &
      & periodic//' adhesion_energy,adhesion_fraction,pull_off_pressure - !adhesion', &
      & on_cells//',surface_sliding pull_off_pressure - !pull_off', &
      & 'free_surface adhesion_area,adhesion_energy,pull_off_load,cells_per_zone - !adhesion', &
      & 'free_surface pull_off_load - !pull_off', &
      & 'free_surface tilt_x,tilt_y - !tilts', &
      & 'wave_1d saturation_fold_pressure,end_of_saturation_pressure,branches_differ,order_margin,zone_leading - !relaxing', &
      & 'wave_1d end_of_saturation_pressure,zone_leading,zone_trailing,friction_stress_without_adhesion - !adhesion', &
      & 'wave_1d,surface_sliding branches_differ - !adhesion', &
      & 'surface_sliding branches_differ - !compared', &
      & 'wave_1d zone_trailing,friction_stress_without_adhesion,adhesive_friction_stress - !relaxing', &
      & 'wave_1d adhesive_friction_stress,hysteresis_loss - !adhesion', &
      & on_cells//' cells_per_zone - !adhesion', &
      & on_cells//' opening_loss - !opens', &
      & 'spectrum_elastic largest_von_mises_x,largest_von_mises_y,largest_shear_x,largest_shear_y - ensemble', &
      & on_cells//' largest_von_mises_stress,largest_von_mises_depth - !stresses', &
      & on_cells//' largest_von_mises_x,largest_von_mises_y - !stresses', &
      & on_cells//' largest_shear_stress,largest_shear_depth,largest_shear_x,largest_shear_y - !stresses', &
      & on_cells//' largest_stress_error - !all_depths', &
      & on_cells//',hertz yield_ratio - !yields', &
      & 'hertz yield_load - !yields', &
      & 'hertz largest_von_mises_stress,largest_von_mises_depth - !stresses', &
      & 'wave_1d hysteresis_loss adhesion_hysteresis', &
      & 'wave_1d elastic_energy - slides', &
      & periodic//' friction_stress,friction_coefficient - !interface', &
      & on_cells//' friction_force -', &
      & on_cells//' smooth_friction_stress - !interface', &
      & on_cells//' smooth_contact_fraction,smooth_friction_stress - layer', &
      & on_cells//' smooth_contact_fraction,smooth_friction_stress - coating', &
      & on_cells//' poisson_defect - !tangential', &
      & 'line_load,strip_load stress_yy stress_zz', &
      & 'line_load,strip_load stress_xy stress_xz', &
      & 'line_load displacement_y displacement_z', &
      & 'wave_1d hysteretic_friction_stress,interfacial_share - !relaxing !coupled', &
      & 'hertz,adhesive_cylinder,wavy_sliding hysteretic_friction_force,interfacial_friction_force - !shear', &
      & 'wave_1d,surface_sliding hysteretic_friction_stress,interfacial_friction_stress - !shear', &
      & 'wavy_sliding hysteretic_friction_force hysteretic_friction_stress', &
      & 'wavy_sliding interfacial_friction_force interfacial_friction_stress', &
      & sums//' interfacial_share - !shear', &
      & sums//','//on_cells//' velocity_slope - !shear', &
      & couples//' largest_coupling,smallest_stiffness_ratio - !coupled', &
      & couples//' coupling_left_out - coupled', &
      & couples//','//on_cells//' coupling_left_out - !shear', &
      & sums//','//on_cells//' velocity_slope - !moves', &
      & heats//' velocity_slope - heat', &
      & 'indenter bulk_heat -', &
      & heats//' contact_temperature,flash_temperature,peak_flash_temperature - !heat', &
      & heats//' background_temperature_rise - !heat', &
      & heats//' thermal_gain,thermal_states,heat_share,bulk_heat,interface_heat - !heat']
   !> Results; in two lists, since a statement goes on over 255 lines at most.
   character(*), parameter :: result_rules(*) = [spectrum_rules, other_rules]

   !> Profiles.
   character(*), parameter :: profile_rules(*) = [character(160) :: &
      & with_depth//' stress_yy_map stress_zz_map', &
      & with_depth//' stress_xy_map stress_xz_map', &
      & 'line_load displacement_y_map displacement_z_map', &
      & 'hertz_history contact_half_width contact_radius paraboloid', &
      & 'hertz_history contact_half_width major_half_width ellipsoid', &
      & 'hertz_history stick_half_width stick_radius paraboloid', &
      & 'hertz_history stick_half_width stick_major_half_width ellipsoid']

   !> Words: the solvers, the variable in their language, each word that is another one in scenes, `old=new`, and the facts.
   character(*), parameter :: word_rules(*) = [character(160) :: &
      & 'wavy_sliding surface%kind wave_2d=wave_1d wave_3d=wave_product map=heights', &
      & 'surface_sliding,surface_time surface%kind heights=profile profile', &
      & 'hertz,hertz_history contact%kind line=cylinder circular=paraboloid elliptical=ellipsoid', &
      & 'rigid_punch punch%kind flat=line_punch polynomial=line_polynomial', &
      & 'indenter,indenter_history,indenter_time shape%kind flat=flat_punch', &
      & 'adhesive_indenter_time,adhesive_indenter_history,attracted_indenter shape%kind flat=flat_punch', &
      & 'indenter model%theory none=hertz', &
      & 'indenter results%theory_used none=hertz', &
      & '* adhesion%branch approach=loading']

   !> What a variable is, where the words of the solvers say only what it is for one of them; and what a result of a solver is.
   character(*), parameter :: meanings(*) = [character(122) :: &
      & 'surface%radius radius of the body, or of curvature at its tip', &
      & 'surface%amplitude amplitude of each wave: half its height from valley to crest', &
      & 'surface%length_x period along x; length of the heights: samples times spacing', &
      & 'surface%length_y period along y; length of the heights: rows times spacing', &
      & 'surface%slope slope of a cone or wedge', &
      & 'operating%velocity sliding velocity along direction, or +x; below 0 the body slides the other way', &
      & 'operating%direction angle from +x, or the major axis, to the sliding or the force', &
      & 'traction%distribution of both tractions: constant, sqrt(1 - x^2/a^2), or sampled', &
      & 'operating%branch which of several states: of round bodies stable, inner or unstable, of waves adhered or loading', &
      & 'output%z_min where profiles begin in depth', &
      & 'output%z_max where profiles end in depth', &
      & 'output%n_z samples of profiles in depth', &
      & 'position%position_z depth of the point below the surface', &
      & 'solid%young_modulus Young''s modulus; with relaxation that of long times', &
      & 'solid%poisson_ratio Poisson''s ratio', &
      & 'adhesion%work_of_adhesion work to part a unit of area: stress times range by Dugdale''s law', &
      & 'adhesion%adhesion_stress largest tension between the surfaces', &
      & 'adhesion%adhesion_range range of the law of adhesion: by Dugdale''s law the largest gap with adhesion', &
      & 'adhesion%theory theory of adhesion; auto: without a range JKR, with one Maugis and Dugdale''s or its limit', &
      & 'adhesion%theory_tolerance largest error of the theory that auto may choose', &
      & 'operating%approach approach of the body from first touch of the undisturbed surface', &
      & 'operating%penetration penetration of the crests below the mean of the deformed surface', &
      & 'friction%shear_strength tau0 of the shear stress in contact; in reduced units: in the scale of lambda', &
      & 'operating%state does the body slide (sliding), roll (rolling), or rest under a tangential force (static)', &
      & 'operating%tangential_displacement tangential displacement of the static state, instead of the force', &
      & 'operating%base_displacement displacement of the base of a lateral spring, from rest, instead of the force', &
      & 'operating%lateral_stiffness stiffness of a lateral spring; the events then have its jumps', &
      & 'operating%contact_half_width half-width of contact, instead of the load; not for a flat punch', &
      & 'operating%major_half_width half-width of contact along the major axis, instead of the load', &
      & 'solid%stiffness stiffness of columns after a long time; E/((1 - nu^2) H) of a layer of the thickness H', &
      & 'numerics%relative_tolerance largest relative error of load and friction (wave_product), or of approach and load in time', &
      & 'numerics%collocation_points number of points where the contact of line_polynomial is solved', &
      & 'friction%law law of the shear stress in contact, shear_strength if not given; peeling: it sticks and peels (JKR)', &
      & 'sphere%friction_force force that keeps the body sliding', &
      & 'operating%load load pressing the bodies together; of a line per length, of a period in foundations; others have pressures']

   !> Values that follow from what a scene leaves out: the solvers, the variable in their language, its value, and the facts.
   !> Without a range adhesion is that of JKR (the third word of `theory`).
   character(*), parameter :: default_rules(*) = [character(160) :: &
      & 'sphere sphere%work_of_adhesion 0 !adhesion', &
      & 'sphere model%theory 3 adhesion !range']

   !> Words that an input which names a model leaves out and its scene says: the solvers, the variable, the word, and the facts, to
   !> which the names count that the input gives. The force of sliding of an indenter stood beside every contact that a shear
   !> strength can hold. A master curve with Poisson's ratio of the layer alone is one of the contact modulus.
   character(*), parameter :: added_words(*) = [character(160) :: &
      & 'indenter operating%state sliding strength !tangential', &
      & 'surface_sliding solid%curve_modulus contact material%master_curve layer%poisson_ratio']

   !> Phrases of the messages, meanings and units of solvers, and behind = what a scene says.
   character(*), parameter :: phrases(*) = [character(160) :: &
      & 'wave_3d and map=wave_product and heights', 'wave_3d=wave_product', 'N/m for line=N/m for cylinder', &
      & '90 degrees=pi/2', '45 degrees=pi/4', '&material=relaxation in &solid', 'make a map of it=sample it as heights', &
      & 'adhesion_stress needs it, or adhesion_range=give two of work_of_adhesion, adhesion_stress and adhesion_range', &
      & 'work_of_adhesion needs it=give two of work_of_adhesion, adhesion_stress and adhesion_range', &
      & 'adhesion_stress needs it=give two of work_of_adhesion, adhesion_stress and adhesion_range', &
      & 'adhesion_range needs it=give two of work_of_adhesion, adhesion_stress and adhesion_range', &
      & 'of a map have=of kind heights have', 'a dataset of two is a map=those of two are of kind heights', &
      & 'give stiffness and moduli=give stiffness and stiffnesses']

   !> Solvers that know a speed and no velocity. Behind each stand its results and profiles, in its language, that are vectors along
   !> the motion or across it: those of a scene take the sign of the velocity.
   character(*), parameter :: of_speed(*) = [character(220) :: &
      & 'wavy_sliding friction_force friction_coefficient contact_shift shear_stress hysteretic_friction_force '// &
      & 'interfacial_friction_force', &
      & 'surface_sliding friction_stress friction_coefficient lateral_stress full_contact_friction contact_shift '// &
      & 'hysteretic_friction_stress interfacial_friction_stress friction_stress_without_adhesion shear_stress']
   !> Those among them whose profiles run along the motion, whatever its direction.
   character(*), parameter :: along_motion = 'wavy_sliding'

end module adfric_describe_scene_rules
