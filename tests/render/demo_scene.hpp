#pragma once
// One page with everything a scene can hold, for the tests and for the eye.

#include <string>

#include "scene/display_list.hpp"

namespace blossom {

Scene demo_scene();
Scene plane_scene();  // only its plane view

// P with a subscript and a superscript, in italics as the book sets it.
RichText point_name(std::string letter, std::string sub, std::string super = {});
RichText plain(std::string text);

}  // namespace blossom
