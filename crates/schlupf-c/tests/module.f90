! The rest of the Fortran module: texts, copies, messages and codes.
program module_test
  use, intrinsic :: iso_c_binding, only: c_double
  use schlupf
  implicit none

  type(schlupf_element) :: one, other
  real(c_double) :: inputs(8), states(3), rates(3)
  real(c_double), allocatable :: outputs(:)

  call check(schlupf_from_file("nowhere.toml", one) == schlupf_unreadable)
  call check(index(schlupf_message(one), "nowhere.toml") > 0)
  call check(schlupf_count(one, schlupf_inputs) == 0)
  call schlupf_destroy(one)
  call check(schlupf_from_text('solver.method = "polach"', one, ["friction.model=constant"]) &
    == schlupf_found)
  call check(schlupf_warnings(one) == "")
  call check(schlupf_name(one, schlupf_outputs, 1) == "force_x")
  allocate (outputs(schlupf_count(one, schlupf_outputs)))
  call check(schlupf_name(one, schlupf_inputs, 5) == "load")
  call check(schlupf_unit(one, schlupf_inputs, 5) == "N")
  call check(schlupf_description(one, schlupf_inputs, 5) == "normal load")
  call check(schlupf_name(one, schlupf_inputs, 9) == "")
  call check(schlupf_find(one, schlupf_states, "elastic_turn ") == 3)
  call check(schlupf_find(one, schlupf_states, "spin") == 0)
  call check(schlupf_start(one, inputs) == schlupf_found)
  call check(schlupf_start(one, inputs(1:7)) == schlupf_wrong_size)
  call check(schlupf_message(one) == "inputs must have 8 numbers, but have 7")
  call check(schlupf_clone(one, other) == schlupf_found)
  call schlupf_destroy(one)
  call check(schlupf_forget(one) == schlupf_invalid_element)
  call check(schlupf_forget(other) == schlupf_found)
  inputs(1) = inputs(1) + 0.1d0
  states = 0
  call check(schlupf_evaluate(other, inputs, states, outputs, rates) == schlupf_found)
  call check(rates(1) > 0 .and. abs(outputs(1)) <= 0)
  call check(schlupf_advance(other, inputs, states, 1d-3) == schlupf_found)
  call check(states(1) > 0)
  deallocate (outputs)
  call schlupf_destroy(other)
  call check(schlupf_from_text('solver.method = "polach"', one) == schlupf_found)
  call check(index(schlupf_warnings(one), "cold-friction: ") == 1)
  call schlupf_destroy(one)

contains

  subroutine check(is_right)
    logical, intent(in) :: is_right
    if (.not. is_right) error stop
  end subroutine
end program
