#include "cli/commands/templates.hpp"

#include <algorithm>
#include <array>

namespace sfumato::cli {
namespace {

constexpr std::string_view kShape =
    R"svg(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1"
     viewBox="0 0 480 320" sf:version="1">
  <title>A shape</title>
  <!-- The colour behind everything. -->
  <rect width="100%" height="100%" fill="#f4efe6"/>
  <!-- A layer: its curves carry colours, which spread from them until they meet others. -->
  <g sf:diffuse="true">
    <!-- A circle runs clockwise from 3 o'clock: its inside is on the right, its outside on the
         left. Colours follow one another along the curve; the last is the first again. -->
    <circle cx="240" cy="160" r="100" sf:left="#f4efe6"
            sf:right="#b5179e, #3a0ca3 25%, #4cc9f0 62%, #b5179e"/>
  </g>
</svg>
)svg";

constexpr std::string_view kSky =
    R"svg(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1"
     viewBox="0 0 480 320" sf:version="1">
  <title>Evening sky</title>
  <g sf:diffuse="true">
    <path d="M-20 -20 H500" sf:left="#1b2a63" sf:right="#1b2a63, #31206b"/>
    <path d="M-20 214 C140 196 330 204 500 212"
          sf:left="#f48a5b, #ffd27f 68%, #ff9d6e" sf:right="#5d3a66"/>
    <circle cx="322" cy="150" r="30" sf:left="#ffcf85" sf:right="#fff6d8" sf:left-blur="24"
            sf:right-blur="3"/>
    <path d="M-20 96 C60 62 150 112 250 92 C330 76 420 54 500 80"
          sf:left="#4a3585, #6b4a92 30%, #43307c" sf:right="#e5808a, #f0a08c 40%, #b7648f"
          sf:blur="4, 22 25%, 3 50%, 20 78%, 6"/>
  </g>
  <g sf:diffuse="true">
    <path d="M-20 250 C70 196 150 262 240 240 C330 218 410 262 500 226 L500 340 L-20 340 Z"
          sf:left="#4a2f5e" sf:right="#4a2f5e, #6b3f63 22%, #2b1d40 60%, #1d1530 90%, #4a2f5e"
          sf:left-opacity="0" sf:right-opacity="1"/>
  </g>
</svg>
)svg";

constexpr std::string_view kSphere =
    R"svg(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1"
     viewBox="0 0 480 320" sf:version="1">
  <title>Sphere</title>
  <g sf:diffuse="true">
    <path d="M-20 -20 H500" sf:left="#8fa6b8" sf:right="#8fa6b8, #b7c7d1"/>
    <path d="M-20 200 H500" sf:left="#d9e2e6" sf:right="#c9bfb2" sf:blur="26"/>
    <path d="M-20 340 H500" sf:left="#efe8dc, #e2d6c4" sf:right="#efe8dc"/>
  </g>
  <g sf:diffuse="true" opacity=".75">
    <ellipse cx="270" cy="254" rx="122" ry="26" sf:left="#2a1a24" sf:right="#2a1a24"
             sf:left-opacity="0" sf:right-opacity="1" sf:blur="16"/>
  </g>
  <g sf:diffuse="true">
    <circle cx="230" cy="152" r="104" sf:left="#7a1420" sf:left-opacity="0" sf:right-opacity="1"
            sf:right="#9c1d28, #4f0d1c 9%, #8c2a33 24%, #b3202c 40%, #e8463c 62%,
                      #c22a30 84%, #9c1d28"/>
    <path d="M160 118 C172 84 206 66 240 70 C232 92 196 104 160 118 Z"
          sf:left="#ef6a58" sf:right="#fff1e6" sf:left-blur="26" sf:right-blur="14"/>
  </g>
</svg>
)svg";

constexpr std::string_view kEye =
    R"svg(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1"
     viewBox="0 0 480 320" sf:version="1">
  <title>Eye</title>
  <g sf:diffuse="true">
    <path d="M-20 -20 H500" sf:left="#e8b796" sf:right="#e8b796, #d9a283"/>
    <path d="M56 182 C120 70 350 56 430 166 C360 250 150 268 56 182 Z"
          sf:left="#8a4f3d, #b8775c 25%, #a8654d 50%, #d49a7c 75%, #8a4f3d"
          sf:right="#d9cdc6, #b9b2b4 25%, #c9bcb8 50%, #fbf7f2 75%, #d9cdc6"
          sf:left-blur="18" sf:right-blur="5"/>
    <path d="M-20 340 H500" sf:left="#f0c6a6, #dfa987" sf:right="#f0c6a6"/>
  </g>
  <g sf:diffuse="true">
    <circle cx="246" cy="160" r="66" sf:left="#173b4a" sf:left-opacity="0" sf:right-opacity="1"
            sf:right="#123443, #2d7f86 25%, #1d5563 50%, #0b2230 75%, #123443" sf:blur="3"/>
    <circle cx="246" cy="160" r="30" sf:left="#6fc3ae, #b9e0b4 25%, #5aa79f 50%,
                      #2b6f78 75%, #6fc3ae"
            sf:right="#060a10" sf:left-blur="16" sf:right-blur="2"/>
  </g>
  <g sf:diffuse="true">
    <circle cx="222" cy="134" r="13" sf:left="#fff" sf:right="#fff" sf:left-opacity="0"
            sf:right-opacity="1" sf:blur="3"/>
  </g>
  <path d="M52 184 C118 66 352 52 434 168" sf:left="#241512" sf:right="#241512"
        sf:radius="3, 15 45%, 3"/>
  <path d="M60 120 C130 40 330 22 424 96" sf:left="#8a4f3d" sf:right="#8a4f3d"
        sf:radius="2, 12 50%, 2" sf:alpha=".6"/>
</svg>
)svg";

constexpr std::string_view kLogo =
    R"svg(<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1"
     viewBox="0 0 480 320" sf:version="1">
  <title>Logo</title>
  <g id="petal-back" sf:diffuse="true">
    <path d="M240 268 C150 236 96 166 112 72 C196 92 252 164 240 268 Z"
          sf:left="#3a0ca3" sf:right="#3a0ca3, #4361ee 30%, #4cc9f0 52%, #4361ee 75%, #3a0ca3"
          sf:left-opacity="0" sf:right-opacity="1"/>
  </g>
  <g id="petal-right" sf:diffuse="true" opacity=".92">
    <path d="M240 268 C228 164 284 92 368 72 C384 166 330 236 240 268 Z"
          sf:left="#f72585" sf:right="#7209b7, #f72585 30%, #ffb703 52%, #f72585 75%, #7209b7"
          sf:left-opacity="0" sf:right-opacity="1"/>
  </g>
  <g id="petal-front" sf:diffuse="true" opacity=".92">
    <path d="M240 268 C184 196 184 112 240 40 C296 112 296 196 240 268 Z"
          sf:left="#b5179e" sf:right="#560bad, #b5179e 28%, #ffd6f5 50%, #b5179e 72%, #560bad"
          sf:left-opacity="0" sf:right-opacity="1"/>
  </g>
</svg>
)svg";

constexpr std::array<Template, 5> kTemplates{
    {{"shape", kShape}, {"sky", kSky}, {"sphere", kSphere}, {"eye", kEye}, {"logo", kLogo}}};

constexpr auto kTemplateNames = [] {
  std::array<std::string_view, kTemplates.size()> names;
  std::ranges::transform(kTemplates, names.begin(), &Template::name);
  return names;
}();

}  // namespace

std::span<const Template> templates() {
  return kTemplates;
}

std::span<const std::string_view> template_names() {
  return kTemplateNames;
}

}  // namespace sfumato::cli
