# Flags of Knotwork's own targets, kept off everything that is not ours.

include_guard(GLOBAL)

# knotwork_own_code(<target>): C++20, warnings, and the one floating-point model that all builds share.
function(knotwork_own_code target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF CXX_VISIBILITY_PRESET hidden
                                             VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
    # GCC 12 sees an overlap in every sum of a literal and a string (its bug 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    $<$<BOOL:${KNOTWORK_WARNINGS_AS_ERRORS}>:-Werror>)
  knotwork_floating_point(${target})
  knotwork_architecture(${target})
  knotwork_webassembly(${target})
  knotwork_exceptions(${target})
  knotwork_sanitizers(${target})
endfunction()

# A fused multiply-add rounds once where a multiplication and an addition round twice. GCC fuses freely on machines that
# have the instruction (64-bit ARM always, x86-64 with -march), WebAssembly never does. Switched off, the same source
# gives the same numbers natively and in the browser, which the oracles' 1e-12 and shared documents rely on.
function(knotwork_floating_point target)
  target_compile_options(${target} PRIVATE -ffp-contract=off)
endfunction()

# For whoever links the target too: Eigen's types are aligned by it.
function(knotwork_architecture target)
  if(KNOTWORK_ARCHITECTURE)
    target_compile_options(${target} PUBLIC "-march=${KNOTWORK_ARCHITECTURE}")
    # GCC 12 finds fault with its own AVX-512 header.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized -Wno-uninitialized)
    endif()
  endif()
endfunction()

# WebAssembly's additions that every browser with SIMD has as well (2023 and later): 128-bit lanes for Eigen and the
# vectorizer; conversions that need no branch around them, single instructions for sign extension and memory copies,
# which all make the module smaller. And link-time optimization, a further three per cent.
function(knotwork_webassembly target)
  if(EMSCRIPTEN)
    target_compile_options(${target} PRIVATE -msimd128 -mnontrapping-fptoint -msign-ext -mbulk-memory
                                             $<$<CONFIG:Release>:-flto>)
    # Where small code is asked for, the compiler leaves even Eigen's access to a coefficient a call: inlined, the page's
    # geometry is three times as fast, for a hundredth of the module.
    target_compile_definitions(${target} PRIVATE EIGEN_STRONG_INLINE=EIGEN_ALWAYS_INLINE)
  endif()
endfunction()

# knotwork_small(<target>): in the page's module, code that runs once an event or a frame is better small than fast; it
# is downloaded by every reader.
function(knotwork_small target)
  if(EMSCRIPTEN)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Oz>)
  endif()
endfunction()

function(knotwork_exceptions target)
  if(NOT KNOTWORK_EXCEPTIONS)
    target_compile_options(${target} PRIVATE -fno-exceptions -fno-rtti)
  endif()
endfunction()

function(knotwork_sanitizers target)
  if(KNOTWORK_SANITIZE)
    # No recovery: a finding ends the test run instead of scrolling past. -O1: sanitized but still quick.
    target_compile_options(${target} PRIVATE -O1 -fsanitize=address,undefined -fno-sanitize-recover=all
                                             -fno-omit-frame-pointer)
    target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
    target_link_options(${target} INTERFACE $<BUILD_INTERFACE:-fsanitize=address,undefined>
                                  PRIVATE -fsanitize=address,undefined)
  endif()
endfunction()
