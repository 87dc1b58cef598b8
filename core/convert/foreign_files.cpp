// SPDX-License-Identifier: Apache-2.0
#include "convert/foreign_files.h"

#include <algorithm>
#include <string>

#include "base/error.h"
#include "base/letters.h"
#include "base/text.h"

namespace handsight {
namespace {

using namespace std::string_view_literals;

/// What a kind of file begins with (from a byte on), or ends its name with, and what the sentence says of it; "FILE"
/// stands for its name.
struct ForeignKind {
  std::string_view begin;
  std::size_t at = 0;
  const char* ending = "";  // of the name; with a `begin` both must be so
  const char* is = "";
  const char* way = "";
};

constexpr ForeignKind kinds[] = {
    {"", 0, ".svo", "a recording of a ZED camera",
     "`ZED_SVO_Editor -s FILE`, or svo_export of the ZED SDK, writes its images"},
    {"", 0, ".svo2", "a recording of a ZED camera", "svo_export of the ZED SDK writes its images"},
    {"\x1A\x45\xDF\xA3"sv, 0, "", "a Matroska video (the recorder of Azure Kinect makes such, too)",
     "`ffmpeg -i FILE images/%04d.png` writes its images"},
    {"ftyp"sv, 4, ".heic", "an image in HEIC", "`heif-convert FILE FILE.png` makes a PNG of it"},
    {"ftyp"sv, 4, "", "a video", "`ffmpeg -i FILE images/%04d.png` writes its images"},
    {"AVI "sv, 8, "", "a video", "`ffmpeg -i FILE images/%04d.png` writes its images"},
    {"\x89HDF\r\n\x1A\n"sv, 0, "", "an HDF5 file",
     "`h5ls -r FILE` lists what is in it, `h5dump -d DATASET -y -o table.csv FILE` writes one of it as a table"},
    {"\x93NUMPY"sv, 0, "", "an array of NumPy",
     "`python3 -c \"import numpy as n; a = n.load('FILE'); n.savetxt('table.csv', a.reshape(len(a), -1), "
     "delimiter=',')\"` "
     "writes it as a table, a 4x4 a row"},
    {"MATLAB 5.0"sv, 0, "", "a file of MATLAB", "`writematrix(A, 'table.csv')` there writes a matrix as a table"},
    {"PAR1"sv, 0, "", "a Parquet table (LeRobot's data sets have such)",
     "`python3 -c \"import pandas; pandas.read_parquet('FILE').to_csv('table.csv')\"` writes it as a table"},
    {"ISO-10303-21"sv, 0, "", "a STEP file: shapes without joints",
     "export the assembly as URDF from the CAD program (sw_urdf_exporter of SolidWorks, onshape-to-robot of Onshape)"},
    {"PXR-USDC"sv, 0, "", "a scene in USD", "Isaac Sim exports its robot as URDF (File, Export to URDF)"},
    {"#usda"sv, 0, "", "a scene in USD", "Isaac Sim exports its robot as URDF (File, Export to URDF)"},
    {"PK\x03\x04"sv, 0, ".xlsx", "a spreadsheet",
     "`libreoffice --headless --convert-to csv FILE` writes it as a table"},
    {"PK\x03\x04"sv, 0, ".ods", "a spreadsheet", "`libreoffice --headless --convert-to csv FILE` writes it as a table"},
    {"\xD0\xCF\x11\xE0"sv, 0, "", "a file of an older Office",
     "`libreoffice --headless --convert-to csv FILE` writes a spreadsheet as a table"},
    {"PK\x03\x04"sv, 0, ".npz", "several arrays of NumPy",
     "`python3 -c \"import numpy as n; f = n.load('FILE'); [n.savetxt(k + '.csv', f[k].reshape(len(f[k]), -1), "
     "delimiter=',') for k in f]\"` writes each as a table"},
    {"PK\x03\x04"sv, 0, "", "a ZIP archive", "`unzip FILE` unpacks it"},
    {"\x1F\x8B"sv, 0, "", "compressed with gzip", "`gunzip FILE` (`tar xzf FILE` of a .tar.gz) unpacks it"},
    {"ustar"sv, 257, "", "a TAR archive", "`tar xf FILE` unpacks it"},
    {"7z\xBC\xAF\x27\x1C"sv, 0, "", "a 7z archive", "`7z x FILE` unpacks it"},
    {"\x28\xB5\x2F\xFD"sv, 0, "", "compressed with zstd", "`unzstd FILE` unpacks it"},
    {"BZh"sv, 0, "", "compressed with bzip2", "`bunzip2 FILE` unpacks it"},
    {"", 0, ".tak", "a take of Motive", "export it there as CSV (File, Export Tracking Data)"},
    {"", 0, ".c3d", "a recording of motion capture in C3D",
     "export it as CSV from the program that recorded it (Motive, Nexus)"},
    {"", 0, ".trc", "markers of motion capture in TRC", "export them as CSV from the program that recorded them"},
    {"", 0, ".pkl", "a pickle of Python", "write its numbers as CSV with the program that made it"},
    {"", 0, ".pt", "tensors of PyTorch", "write their numbers as CSV with the program that made them"},
    {"%PDF"sv, 0, "", "a PDF", "name the numbers as a table (CSV)"},
};

constexpr std::string_view image_begins[] = {"\x89PNG"sv, "\xFF\xD8\xFF"sv, "II*\0"sv, "MM\0*"sv,
                                             "P5\n"sv,    "P6\n"sv,         "BM"sv};

bool is_image(std::string_view begin) {
  const bool is_webp =
      begin.starts_with("RIFF") && begin.substr(std::min<std::size_t>(8, begin.size())).starts_with("WEBP");
  return is_webp || std::any_of(std::begin(image_begins), std::end(image_begins),
                                [&](std::string_view b) { return begin.starts_with(b); });
}

bool is_of(const ForeignKind& kind, const std::string& name, std::string_view begin) {
  const bool begins = begin.size() >= kind.at && begin.substr(kind.at).starts_with(kind.begin);
  return begins && name.ends_with(kind.ending);
}

std::string with_file(std::string text, const std::string& file) {
  for (std::size_t at = text.find("FILE"); at != std::string::npos; at = text.find("FILE", at + file.size()))
    text.replace(at, 4, file);
  return text;
}

}  // namespace

void refuse_foreign_file(const std::filesystem::path& path, std::string_view begin) {
  const std::string name = lower_case(path.filename().string());
  if (is_image(begin))
    throw InputError(message("{}: is one image; name the folder that holds the images.", shown_path(path)));
  for (const ForeignKind& kind : kinds)
    if (is_of(kind, name, begin))
      throw InputError(message("{}: is {}, which is not read; {}.", shown_path(path), kind.is,
                               with_file(kind.way, shortened(path.filename().string(), 60))));
}

}  // namespace handsight
