# Debian's Arduino core as the library `core`, for the projects that avr-g++ builds.
set(ARDUINO_AVR /usr/share/arduino/hardware/arduino/avr CACHE PATH "Where arduino-core-avr is")

file(GLOB core_sources ${ARDUINO_AVR}/cores/arduino/*.c ${ARDUINO_AVR}/cores/arduino/*.cpp
     ${ARDUINO_AVR}/cores/arduino/*.S)
add_library(core STATIC ${core_sources})
# Not SYSTEM: this gcc would take such headers for C.
target_include_directories(core PUBLIC ${ARDUINO_AVR}/cores/arduino
                           ${ARDUINO_AVR}/variants/standard)
target_compile_options(core PRIVATE -w)

# A sketch is C++ in spite of its suffix, and the Arduino IDE includes Arduino.h at its top.
function(elf_of_sketch name sketch)
  set_source_files_properties(${sketch} PROPERTIES LANGUAGE CXX
                              COMPILE_OPTIONS "-x;c++;-include;Arduino.h")
  add_executable(${name} ${sketch} ${ARGN})
  target_compile_options(${name} PRIVATE -Wall -Wextra)
  target_link_libraries(${name} PRIVATE core m)
  set_target_properties(${name} PROPERTIES SUFFIX .elf)
endfunction()
