! A wheel brakes for ten seconds: linearly implicit steps with the derivative of the force.
program brake
  use, intrinsic :: iso_c_binding, only: c_double
  use, intrinsic :: iso_fortran_env, only: error_unit
  use schlupf
  implicit none

  real(c_double), parameter :: radius = 0.46d0, inertia = 70d0, mass = 8000d0, torque = 4000d0, &
    step = 1d-3
  character(*), parameter :: case = 'kinematics.speed = "20 m/s"' // new_line("a") // &
    'friction = { model = "constant", coefficient = 0.4 }'
  character(24), parameter :: overrides(2) = &
    [character(24) :: "normal.load=80 kN", "solver.method=polach"]
  type(schlupf_element) :: wheel
  real(c_double), allocatable :: inputs(:), states(:), outputs(:), slopes(:, :)
  real(c_double) :: fx
  integer :: v, omega, force, n, k

  if (schlupf_from_text(case, wheel, overrides) /= schlupf_found) call stop_with_message
  v = schlupf_find(wheel, schlupf_inputs, "velocity_x")
  omega = schlupf_find(wheel, schlupf_inputs, "angular_velocity")
  force = schlupf_find(wheel, schlupf_outputs, "force_x")
  n = schlupf_count(wheel, schlupf_states)
  allocate(inputs(schlupf_count(wheel, schlupf_inputs)), states(n))
  allocate(outputs(schlupf_count(wheel, schlupf_outputs)))
  allocate(slopes(size(inputs) + n, size(outputs) + n))
  if (schlupf_start(wheel, inputs) /= schlupf_found) call stop_with_message
  states = 0
  do k = 0, 10000
    if (schlupf_evaluate(wheel, inputs, states, outputs, derivatives=slopes) /= schlupf_found) &
      call stop_with_message
    fx = outputs(force)
    if (mod(k, 2000) == 0) print "(3es25.16e3)", inputs(v), inputs(omega), fx
    inputs(v) = inputs(v) + step * fx / mass
    inputs(omega) = inputs(omega) + step * (-radius * fx - torque) &
      / (inertia + step * radius * slopes(omega, force))
    if (schlupf_advance(wheel, inputs, states, step) /= schlupf_found) call stop_with_message
  end do
  call schlupf_destroy(wheel)
  deallocate(inputs, states, outputs, slopes)

contains

  subroutine stop_with_message
    write (error_unit, "(a)") schlupf_message(wheel)
    stop 1
  end subroutine
end program
