// SPDX-License-Identifier: Apache-2.0
// Surfaces of links from mesh files: STL (binary and text), OBJ, and Collada (collada_text.h). A reader of our own,
// because a file that lies about its own content must not reach a library that believes it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "robot/mesh_types.h"

namespace handsight {

/// An OBJ text: its v and f lines, polygons as fans of triangles; everything else is passed over. InputError names the
/// line of what is wrong; `file` is what sentences call it.
Mesh parse_obj(std::string_view text, const std::string& file);

/// An STL file's bytes; equal points are one.
Mesh parse_stl(std::string_view bytes, const std::string& file);

/// Reads a file by its ending, .stl, .obj or .dae. InputError where it is of another kind, wrong, or without a
/// triangle.
Mesh read_mesh(const std::filesystem::path& file);

/// Where a mesh that a URDF in this folder names lies: as written, without "package://" or "file://", without the
/// package's name, or by its name alone; only inside the folder, or inside the session's folder where that is above it
/// (links are followed first). Nothing where there is no such file there.
std::optional<std::filesystem::path> find_mesh(const std::string& written, const std::filesystem::path& urdf_folder);

}  // namespace handsight
