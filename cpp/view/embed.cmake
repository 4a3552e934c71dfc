# cmake -DINPUT=<text file> -DNAME=<function> -DOUTPUT=<.cpp> -P embed.cmake
# Makes a text file a function of the program: std::string_view certet::view::NAME().
file(READ "${INPUT}" text)
file(WRITE "${OUTPUT}" "#include <string_view>
namespace certet::view {
std::string_view ${NAME}() {
  return R\"~embedded~(${text})~embedded~\";
}
}
")
