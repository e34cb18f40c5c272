#include "client/gallery/gallery_page.h"

#include <algorithm>

#include "common/embedded_file.h"
#include "common/text.h"
#include "protocol/codec.h"

namespace aucast::gallery {
namespace {

/// The names of channels. A channel that both sides have is named once, without its side.
std::string in_pairs(const std::vector<std::string>& channels) {
  const auto has = [&](const std::string& name) {
    return std::find(channels.begin(), channels.end(), name) != channels.end();
  };
  std::string text;
  for (const std::string& channel : channels) {
    const auto [side, base] = split_side(channel);
    const bool paired = side != Side::Both && has(sided_name(opposite(side), base));
    if (paired && side == Side::Right) continue;
    text += (text.empty() ? "" : ", ") + (paired ? std::string(base) : channel);
  }
  return text;
}

/// Whether a note says no more than the name does.
bool repeats(std::string_view note, std::string_view name) {
  return lowered(note) == lowered(name);
}

/// Builds the page piece by piece; each function adds one kind of element.
class Page {
 public:
  Page(const GalleryPlan& plan, const GallerySetting& setting,
       const std::vector<std::size_t>& videos)
      : plan_(plan), setting_(setting), videos_(videos) {}

  std::string text() {
    head();
    for (const GallerySection& section : plan_.sections) add(section);
    coverage();
    html_ += "</main>\n<footer>face-player " + html_escaped(setting_.version) +
             ". Every picture and how it was made: <a href=\"manifest.csv\">manifest.csv</a>"
             ".</footer>\n</body>\n</html>\n";
    return std::move(html_);
  }

 private:
  void head() {
    const std::string title = "Gallery of the face " + html_escaped(setting_.face);
    html_ =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
        title + "</title>\n<style>\n" + std::string(embedded::gallery_styles().front().bytes) +
        "</style>\n</head>\n<body>\n<header>\n<h1>" + title + "</h1>\n<p>" +
        std::to_string(plan_.pictures.size()) + " pictures, " + std::to_string(setting_.width) +
        " x " + std::to_string(setting_.height) + ", camera " + html_escaped(setting_.viewpoint) +
        ", background " + html_escaped(setting_.background) +
        ". A click opens a picture in its full size.</p>\n</header>\n<nav><div>\n";
    for (const GallerySection& section : plan_.sections) {
      html_ += "<a href=\"#" + section.name + "\">" + html_escaped(section.title) + "</a>\n";
    }
    html_ += "<a href=\"#coverage\">Coverage</a>\n</div></nav>\n<main>\n";
  }

  void add(const GallerySection& section) {
    html_ += "<section>\n<h2 id=\"" + section.name + "\">" + html_escaped(section.title) +
             "</h2>\n<p>" + html_escaped(section.text) + "</p>\n";
    const bool indexed = section.blocks.size() > 8;
    if (indexed) index(section);
    for (std::size_t i = 0; i < section.blocks.size(); ++i) {
      const GalleryBlock& block = section.blocks[i];
      if (!block.heading.empty()) {
        html_ += "<h3 id=\"" + anchor(section, i) + "\">" + html_escaped(block.heading) + "</h3>\n";
      }
      block.columns.empty() ? flow(block) : table(block);
    }
    html_ += "</section>\n";
  }

  static std::string anchor(const GallerySection& section, std::size_t block) {
    return section.name + "-" + std::to_string(block + 1);
  }

  void index(const GallerySection& section) {
    html_ += "<div class=\"index\">\n";
    for (std::size_t i = 0; i < section.blocks.size(); ++i) {
      // "AU 12 Lip Corner Puller": the number is enough here, the name comes when pointed at.
      const std::string& heading = section.blocks[i].heading;
      if (heading.empty()) continue;
      const std::size_t end = heading.find(' ', heading.find(' ') + 1);
      html_ += "<a href=\"#" + anchor(section, i) + "\" title=\"" + html_escaped(heading) + "\">" +
               html_escaped(section.name == "aus" ? heading.substr(0, end) : heading) + "</a>\n";
    }
    html_ += "</div>\n";
  }

  void flow(const GalleryBlock& block) {
    html_ += "<div class=\"flow\">\n";
    for (const GalleryRow& row : block.rows) {
      for (const GalleryFigure& one : row.figures) figure(one, block.heading);
    }
    html_ += "</div>\n";
  }

  void table(const GalleryBlock& block) {
    const bool headed = std::any_of(block.rows.begin(), block.rows.end(),
                                    [](const GalleryRow& row) { return !row.heading.empty(); });
    html_ += "<table class=\"pictures\">\n<tr>";
    if (headed) html_ += "<td style=\"width:5.5rem\"></td>";
    for (const std::string& column : block.columns) {
      html_ += "<th scope=\"col\">" + html_escaped(column) + "</th>";
    }
    html_ += "</tr>\n";
    for (const GalleryRow& row : block.rows) {
      html_ += "<tr>";
      if (headed) html_ += "<th scope=\"row\">" + html_escaped(row.heading) + "</th>";
      for (const GalleryFigure& one : row.figures) {
        html_ += "<td>";
        figure(one, block.heading + " " + row.heading);
        html_ += "</td>";
      }
      html_ += "</tr>\n";
    }
    html_ += "</table>\n";
  }

  void figure(const GalleryFigure& figure, const std::string& context) {
    html_ += "<figure>";
    if (figure.picture) {
      const GalleryPicture& picture = plan_.pictures[*figure.picture];
      const std::string file = html_escaped(picture.file);
      html_ += "<a href=\"" + file + "\"><img loading=\"lazy\" src=\"" + file + "\" width=\"" +
               std::to_string(setting_.width) + "\" height=\"" + std::to_string(setting_.height) +
               "\" alt=\"" + html_escaped(context + " " + figure.title) + ", " +
               html_escaped(protocol::format_au_set(picture.aus)) + "\"></a>";
    } else {
      html_ += "<div class=\"empty\">not on this face</div>";
    }
    caption(figure);
    html_ += "</figure>\n";
  }

  void caption(const GalleryFigure& figure) {
    if (figure.title.empty() && figure.text.empty() && figure.video == 0) return;
    html_ += "<figcaption>" + html_escaped(figure.title);
    if (!figure.text.empty()) html_ += "<span>" + html_escaped(figure.text) + "</span>";
    if (figure.video != 0) {
      const GallerySweep& sweep = plan_.sweeps[figure.video - 1];
      const std::string place = "sweeps/" + html_escaped(sweep.name);
      html_ += "<span><a href=\"" + place + "/\">" + std::to_string(sweep.count) + " frames</a>";
      if (std::find(videos_.begin(), videos_.end(), figure.video - 1) != videos_.end()) {
        html_ += ", <a href=\"" + place + ".mp4\">video</a>";
      }
      html_ += "</span>";
    }
    html_ += "</figcaption>";
  }

  void coverage() {
    const auto recorded = std::count_if(plan_.coverage.begin(), plan_.coverage.end(),
                                        [](const Coverage& row) { return row.recorded; });
    html_ +=
        "<section>\n<h2 id=\"coverage\">Coverage</h2>\n<p>The Action Units of the thesis' appendix "
        "C: " +
        std::to_string(recorded) + " of " + std::to_string(plan_.coverage.size()) +
        " are recorded on this face. Marked are those that the mesh cannot show well; their best "
        "form is there.</p>\n<table class=\"coverage\">\n<tr><th>AU</th><th>FACS name</th><th>On "
        "this face</th><th>Sides</th><th>Note</th><th>Drives</th></tr>\n";
    for (const Coverage& row : plan_.coverage) coverage_row(row);
    html_ += "</table>\n</section>\n";
  }

  void coverage_row(const Coverage& row) {
    const char* mark = !row.recorded     ? "<span class=\"mark missing\">not recorded</span>"
                       : is_limited(row) ? "<span class=\"mark limited\">best form</span>"
                                         : "<span class=\"mark\">recorded</span>";
    const std::string drives = in_pairs(row.drives);
    html_ += "<tr><td>" + std::to_string(row.number) + "</td><td>" + html_escaped(row.name) +
             "</td><td>" + mark + "</td><td>" + (row.sided ? "left, right" : "") + "</td><td>" +
             html_escaped(repeats(row.note, row.name) ? "" : row.note) +
             "</td><td class=\"drives\">" + html_escaped(drives) + "</td></tr>\n";
  }

  const GalleryPlan& plan_;
  const GallerySetting& setting_;
  const std::vector<std::size_t>& videos_;
  std::string html_;
};

}  // namespace

std::string html_escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string format_page(const GalleryPlan& plan, const GallerySetting& setting,
                        const std::vector<std::size_t>& videos) {
  return Page(plan, setting, videos).text();
}

}  // namespace aucast::gallery
