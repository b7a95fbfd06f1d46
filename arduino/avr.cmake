# Toolchain: Debian's gcc-avr for the ATmega328P of an Arduino Uno or Nano.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR avr)
set(CMAKE_C_COMPILER avr-gcc)
set(CMAKE_CXX_COMPILER avr-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(board "-mmcu=atmega328p -DF_CPU=16000000UL -DARDUINO=10819 -DARDUINO_AVR_UNO -DARDUINO_ARCH_AVR")
set(lean "-Os -ffunction-sections -fdata-sections -fno-fat-lto-objects")
set(CMAKE_C_FLAGS_INIT "${board} ${lean}")
set(CMAKE_ASM_FLAGS_INIT "${board}")
# As the Arduino IDE does: C++11, no exceptions. DECIMAL_DIG is missing in this gcc's C++.
set(CMAKE_CXX_FLAGS_INIT "${board} ${lean} -std=gnu++11 -fno-exceptions -fno-threadsafe-statics -DDECIMAL_DIG=__DECIMAL_DIG__")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-mmcu=atmega328p -Os -Wl,--gc-sections")
