! schlupf: the force element in Fortran 2008. Compile it with the program; link with -lschlupf.
!
! What the functions do is in schlupf.h. Optional arrays are found where they are given. Derivatives
! are (variables, results): derivatives(by, of).
module schlupf
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_int32_t, &
    c_int64_t, c_intptr_t, c_loc, c_null_char, c_null_ptr, c_ptr, c_size_t
  implicit none
  private

  integer(c_int32_t), parameter, public :: schlupf_found = 0, schlupf_no_contact = 1, &
    schlupf_not_finite = 2, schlupf_not_converged = 3, schlupf_wrong_size = 4, &
    schlupf_invalid_pointer = 5, schlupf_invalid_element = 6, schlupf_busy = 7, &
    schlupf_invalid_case = 8, schlupf_unreadable = 9, schlupf_too_many = 10, schlupf_panicked = 11, &
    schlupf_outside_table = 12
  integer(c_int32_t), parameter, public :: schlupf_inputs = 0, schlupf_outputs = 1, &
    schlupf_states = 2

  ! An element; a copy is the same element. schlupf_clone makes another.
  type, public :: schlupf_element
    integer(c_int64_t) :: number = 0
  end type

  public :: schlupf_from_text, schlupf_from_file, schlupf_clone, schlupf_destroy, schlupf_count, &
    schlupf_name, schlupf_unit, schlupf_description, schlupf_find, schlupf_start, &
    schlupf_evaluate, schlupf_advance, schlupf_forget, schlupf_message, schlupf_warnings

  interface
    function c_from_text(text, folder, set, count, element) &
        bind(c, name="schlupf_element_from_text") result(status)
      import
      character(kind=c_char), intent(in) :: text(*), folder(*)
      type(c_ptr), intent(in) :: set(*)
      integer(c_size_t), value :: count
      integer(c_int64_t), intent(out) :: element
      integer(c_int32_t) :: status
    end function
    function c_from_file(path, set, count, element) &
        bind(c, name="schlupf_element_from_file") result(status)
      import
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), intent(in) :: set(*)
      integer(c_size_t), value :: count
      integer(c_int64_t), intent(out) :: element
      integer(c_int32_t) :: status
    end function
    function c_clone(element, copy) bind(c, name="schlupf_element_clone") result(status)
      import
      integer(c_int64_t), value :: element
      integer(c_int64_t), intent(out) :: copy
      integer(c_int32_t) :: status
    end function
    function c_destroy(element) bind(c, name="schlupf_element_destroy") result(status)
      import
      integer(c_int64_t), value :: element
      integer(c_int32_t) :: status
    end function
    function c_count(element, kind) bind(c, name="schlupf_element_count") result(count)
      import
      integer(c_int64_t), value :: element
      integer(c_int32_t), value :: kind
      integer(c_size_t) :: count
    end function
    function c_name(element, kind, index) bind(c, name="schlupf_element_name") result(text)
      import
      integer(c_int64_t), value :: element
      integer(c_int32_t), value :: kind
      integer(c_size_t), value :: index
      type(c_ptr) :: text
    end function
    function c_unit(element, kind, index) bind(c, name="schlupf_element_unit") result(text)
      import
      integer(c_int64_t), value :: element
      integer(c_int32_t), value :: kind
      integer(c_size_t), value :: index
      type(c_ptr) :: text
    end function
    function c_description(element, kind, index) &
        bind(c, name="schlupf_element_description") result(text)
      import
      integer(c_int64_t), value :: element
      integer(c_int32_t), value :: kind
      integer(c_size_t), value :: index
      type(c_ptr) :: text
    end function
    function c_find(element, kind, name) bind(c, name="schlupf_element_find") result(index)
      import
      integer(c_int64_t), value :: element
      integer(c_int32_t), value :: kind
      character(kind=c_char), intent(in) :: name(*)
      integer(c_intptr_t) :: index
    end function
    function c_start(element, inputs, count) bind(c, name="schlupf_element_start") result(status)
      import
      integer(c_int64_t), value :: element
      integer(c_size_t), value :: count
      real(c_double), intent(out) :: inputs(count)
      integer(c_int32_t) :: status
    end function
    function c_evaluate(element, inputs, input_count, states, state_count, outputs, output_count, &
        rates, rate_count, derivatives, derivative_count) &
        bind(c, name="schlupf_element_evaluate") result(status)
      import
      integer(c_int64_t), value :: element
      integer(c_size_t), value :: input_count, state_count, output_count, rate_count, &
        derivative_count
      real(c_double), intent(in) :: inputs(*), states(*)
      real(c_double), intent(inout) :: outputs(*)
      type(c_ptr), value :: rates, derivatives
      integer(c_int32_t) :: status
    end function
    function c_advance(element, inputs, input_count, states, state_count, duration) &
        bind(c, name="schlupf_element_advance") result(status)
      import
      integer(c_int64_t), value :: element
      integer(c_size_t), value :: input_count, state_count
      real(c_double), intent(in) :: inputs(*)
      real(c_double), intent(inout) :: states(*)
      real(c_double), value :: duration
      integer(c_int32_t) :: status
    end function
    function c_forget(element) bind(c, name="schlupf_element_forget") result(status)
      import
      integer(c_int64_t), value :: element
      integer(c_int32_t) :: status
    end function
    function c_strlen(text) bind(c, name="strlen") result(length)
      import
      type(c_ptr), value :: text
      integer(c_size_t) :: length
    end function
  end interface

  abstract interface
    function c_text(element, place, size) bind(c) result(whole)
      import
      integer(c_int64_t), value :: element
      integer(c_size_t), value :: size
      character(kind=c_char), intent(out) :: place(*)
      integer(c_size_t) :: whole
    end function
  end interface

  procedure(c_text), bind(c, name="schlupf_element_message") :: c_message
  procedure(c_text), bind(c, name="schlupf_element_warnings") :: c_warnings

contains

  ! Overrides are section.field=value, blanks at their ends do not count.
  integer function schlupf_from_text(text, element, overrides, folder) result(status)
    character(*), intent(in) :: text
    type(schlupf_element), intent(out) :: element
    character(*), intent(in), optional :: overrides(:), folder
    character(:), allocatable :: place
    character(1, kind=c_char), allocatable, target :: letters(:)
    type(c_ptr), allocatable :: set(:)
    place = ""
    if (present(folder)) place = folder
    call terminate(letters, set, overrides)
    status = c_from_text(text // c_null_char, place // c_null_char, set, &
      size(set, kind=c_size_t), element%number)
  end function

  integer function schlupf_from_file(path, element, overrides) result(status)
    character(*), intent(in) :: path
    type(schlupf_element), intent(out) :: element
    character(*), intent(in), optional :: overrides(:)
    character(1, kind=c_char), allocatable, target :: letters(:)
    type(c_ptr), allocatable :: set(:)
    call terminate(letters, set, overrides)
    status = c_from_file(trim(path) // c_null_char, set, size(set, kind=c_size_t), &
      element%number)
  end function

  ! The letters of the overrides, each with a null at its end, and where each begins.
  subroutine terminate(letters, places, overrides)
    character(1, kind=c_char), allocatable, target, intent(out) :: letters(:)
    type(c_ptr), allocatable, intent(out) :: places(:)
    character(*), intent(in), optional :: overrides(:)
    integer :: k, length, first, n
    n = 0
    if (present(overrides)) n = size(overrides)
    length = 1
    if (n > 0) length = len(overrides) + 1
    allocate(letters(n * length), places(n))
    do k = 1, n
      first = 1 + (k - 1) * length
      letters(first:first + length - 1) = &
        transfer(trim(overrides(k)) // repeat(c_null_char, length), letters, length)
      places(k) = c_loc(letters(first))
    end do
  end subroutine

  integer function schlupf_clone(element, copy) result(status)
    type(schlupf_element), intent(in) :: element
    type(schlupf_element), intent(out) :: copy
    status = c_clone(element%number, copy%number)
  end function

  subroutine schlupf_destroy(element)
    type(schlupf_element), intent(inout) :: element
    integer(c_int32_t) :: status
    status = c_destroy(element%number)
    element%number = 0
  end subroutine

  integer function schlupf_count(element, kind) result(count)
    type(schlupf_element), intent(in) :: element
    integer, intent(in) :: kind
    count = int(c_count(element%number, kind))
  end function

  ! Indices begin with 1.
  function schlupf_name(element, kind, index) result(text)
    type(schlupf_element), intent(in) :: element
    integer, intent(in) :: kind, index
    character(:), allocatable :: text
    text = read_text(c_name(element%number, kind, index - 1_c_size_t))
  end function

  function schlupf_unit(element, kind, index) result(text)
    type(schlupf_element), intent(in) :: element
    integer, intent(in) :: kind, index
    character(:), allocatable :: text
    text = read_text(c_unit(element%number, kind, index - 1_c_size_t))
  end function

  function schlupf_description(element, kind, index) result(text)
    type(schlupf_element), intent(in) :: element
    integer, intent(in) :: kind, index
    character(:), allocatable :: text
    text = read_text(c_description(element%number, kind, index - 1_c_size_t))
  end function

  ! 0 where there is none.
  integer function schlupf_find(element, kind, name) result(index)
    type(schlupf_element), intent(in) :: element
    integer, intent(in) :: kind
    character(*), intent(in) :: name
    index = int(c_find(element%number, kind, trim(name) // c_null_char)) + 1
  end function

  integer function schlupf_start(element, inputs) result(status)
    type(schlupf_element), intent(in) :: element
    real(c_double), intent(out) :: inputs(:)
    status = c_start(element%number, inputs, size(inputs, kind=c_size_t))
  end function

  integer function schlupf_evaluate(element, inputs, states, outputs, rates, derivatives) &
      result(status)
    type(schlupf_element), intent(in) :: element
    real(c_double), intent(in), contiguous :: inputs(:), states(:)
    real(c_double), intent(inout), contiguous :: outputs(:)
    real(c_double), intent(inout), contiguous, optional, target :: rates(:), derivatives(:, :)
    type(c_ptr) :: rate_place, place
    integer(c_size_t) :: rate_count, count
    rate_place = c_null_ptr
    place = c_null_ptr
    rate_count = 0
    count = 0
    if (present(rates)) rate_count = size(rates)
    if (rate_count > 0) rate_place = c_loc(rates)
    if (present(derivatives)) count = size(derivatives)
    if (count > 0) place = c_loc(derivatives)
    status = c_evaluate(element%number, inputs, size(inputs, kind=c_size_t), states, &
      size(states, kind=c_size_t), outputs, size(outputs, kind=c_size_t), rate_place, rate_count, &
      place, count)
  end function

  integer function schlupf_advance(element, inputs, states, duration) result(status)
    type(schlupf_element), intent(in) :: element
    real(c_double), intent(in), contiguous :: inputs(:)
    real(c_double), intent(inout), contiguous :: states(:)
    real(c_double), intent(in) :: duration
    status = c_advance(element%number, inputs, size(inputs, kind=c_size_t), states, &
      size(states, kind=c_size_t), duration)
  end function

  integer function schlupf_forget(element) result(status)
    type(schlupf_element), intent(in) :: element
    status = c_forget(element%number)
  end function

  function schlupf_message(element) result(text)
    type(schlupf_element), intent(in) :: element
    character(:), allocatable :: text
    text = text_of(element, c_message)
  end function

  ! What its method neglects, a line for each warning.
  function schlupf_warnings(element) result(text)
    type(schlupf_element), intent(in) :: element
    character(:), allocatable :: text
    text = text_of(element, c_warnings)
  end function

  function text_of(element, of) result(text)
    type(schlupf_element), intent(in) :: element
    procedure(c_text) :: of
    character(:), allocatable :: text
    character(:, kind=c_char), allocatable :: whole
    character(1, kind=c_char) :: none(1)
    integer(c_size_t) :: length
    length = of(element%number, none, 1_c_size_t)
    allocate(character(length + 1) :: whole)
    length = of(element%number, whole, length + 1)
    text = whole(:length)
  end function

  function read_text(place) result(text)
    type(c_ptr), intent(in) :: place
    character(:), allocatable :: text
    character(1, kind=c_char), pointer :: letters(:)
    integer(c_size_t) :: k, length
    length = 0
    if (c_associated(place)) length = c_strlen(place)
    allocate(character(length) :: text)
    if (length > 0) call c_f_pointer(place, letters, [length])
    do k = 1, length
      text(k:k) = letters(k)
    end do
  end function
end module
