# schlupf::schlupf, the shared library, and schlupf::static.
get_filename_component(schlupf_PREFIX "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
foreach(kind IN ITEMS schlupf static)
  if(NOT TARGET schlupf::${kind})
    if(kind STREQUAL "static")
      add_library(schlupf::static STATIC IMPORTED)
      set_target_properties(schlupf::static PROPERTIES
        IMPORTED_LOCATION "${schlupf_PREFIX}/lib/libschlupf.a"
        INTERFACE_LINK_LIBRARIES "@PRIVATE@")
    else()
      add_library(schlupf::schlupf SHARED IMPORTED)
      set_target_properties(schlupf::schlupf PROPERTIES
        IMPORTED_LOCATION "${schlupf_PREFIX}/lib/@SHARED@")
    endif()
    set_target_properties(schlupf::${kind} PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES "${schlupf_PREFIX}/include")
  endif()
endforeach()
