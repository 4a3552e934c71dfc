"""Programs of others use an installed certet, and certet as a subfolder."""

import shutil
import subprocess
import unittest

from project import BUILD, CMAKE, EXAMPLES, SOURCE, PackageTest


OPTIONAL = ("ITK", "MUPARSER", "BOOST", "ASSIMP", "OPENVDB", "ZLIB", "HDF5", "PNG", "THREE", "PYBIND11")


def without(*parts):
    return [f"-DCERTET_{part}=OFF" for part in parts]


def examples():
    return sorted(p.parent for p in EXAMPLES.glob("*/CMakeLists.txt"))


class Installed(PackageTest):
    """The build that is tested, as it is installed."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.prefix = cls.folder / "prefix"
        cls.run_program(CMAKE, "--install", BUILD, "--prefix", cls.prefix)

    def test_examples(self):
        self.assertTrue(examples())
        for example in examples():
            with self.subTest(example.name):
                build = self.configure_and_build(example, example.name,
                                                 f"-DCMAKE_PREFIX_PATH={self.prefix}")
                self.run_program(build / example.name, cwd=build)

    def test_program(self):
        certet = self.prefix / "bin" / "certet"
        self.assertIn("certet", self.run_program(certet, "--version"))

    def test_nothing_of_the_build_is_left(self):
        for file in self.prefix.rglob("*"):
            if file.suffix in (".cmake", ".pc", ".hpp", ".1"):
                text = file.read_text()
                self.assertNotIn(str(BUILD), text, file)
                self.assertNotIn(str(SOURCE), text, file)

    def test_headers_are_all_there(self):
        public = SOURCE / "cpp" / "include"
        for header in public.rglob("*.hpp"):
            self.assertTrue((self.prefix / "include" / header.relative_to(public)).exists())

    def test_unknown_component_is_refused(self):
        project = self.folder / "unknown"
        project.mkdir()
        (project / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(unknown CXX)\n"
            "find_package(certet REQUIRED COMPONENTS teapot)\n")
        run = subprocess.run([CMAKE, "-S", project, "-B", project / "build",
                              f"-DCMAKE_PREFIX_PATH={self.prefix}"], text=True,
                             capture_output=True)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("teapot", run.stderr)


class SharedCore(PackageTest):
    """Shared libraries without any optional part, found by CMake and pkg-config."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.prefix = cls.folder / "prefix"
        build = cls.configure_and_build(
            SOURCE, "certet", "-DBUILD_SHARED_LIBS=ON", "-DCMAKE_BUILD_TYPE=None",
            "-DCERTET_UNITY=ON", *without("TBB", *OPTIONAL),
            "-DCERTET_TESTS=OFF", "-DCERTET_BENCH=OFF", "-DCMAKE_INSTALL_LIBDIR=lib",
            f"-DCMAKE_INSTALL_PREFIX={cls.prefix}")
        cls.run_program(CMAKE, "--install", build)
        shutil.rmtree(build)  # nothing may reach back into it

    def test_find_package(self):
        example = EXAMPLES / "implicit_function"
        build = self.configure_and_build(example, "found", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.run_program(build / "implicit_function", cwd=build)

    def test_program_finds_its_libraries(self):
        self.assertIn("certet", self.run_program(self.prefix / "bin" / "certet", "--version"))

    def test_names_of_the_library(self):
        names = {p.name for p in (self.prefix / "lib").glob("libcertet.so*")}
        self.assertEqual(len(names), 3, names)

    @unittest.skipIf(shutil.which("pkg-config") is None, "no pkg-config")
    def test_pkg_config(self):
        environment = {"PKG_CONFIG_PATH": str(self.prefix / "lib" / "pkgconfig"),
                       "PATH": "/usr/bin:/bin"}
        flags = self.run_program("pkg-config", "--cflags", "--libs", "certet",
                                 env=environment).split()
        program = self.folder / "by_pkg_config"
        self.run_program("c++", "-std=c++20", EXAMPLES / "implicit_function" / "main.cpp",
                         "-o", program, *flags, f"-Wl,-rpath,{self.prefix / 'lib'}")
        self.run_program(program, cwd=self.folder)


class Subfolder(PackageTest):
    def test_add_subdirectory(self):
        project = self.folder / "project"
        project.mkdir()
        main = (EXAMPLES / "implicit_function" / "main.cpp").as_posix()
        (project / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(outer CXX)\n"
            "set(CERTET_COMMAND OFF)\n"
            f"add_subdirectory({SOURCE.as_posix()} certet)\nadd_executable(outer {main})\n"
            "target_link_libraries(outer certet::certet certet::image certet::formula)\n")
        build = self.configure_and_build(project, "outer", "-DCMAKE_BUILD_TYPE=None",
                                         "-DCMAKE_POLICY_DEFAULT_CMP0077=NEW",
                                         "-DCMAKE_POLICY_DEFAULT_CMP0126=NEW",
                                         "-DCERTET_UNITY=ON", *without(*OPTIONAL), target="outer")
        program = next(p for p in (build / "outer", build / "bin" / "outer") if p.exists())
        self.run_program(program, cwd=self.folder)


if __name__ == "__main__":
    unittest.main()
