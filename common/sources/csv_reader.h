#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/error_list.h"
#include "common/result.h"

namespace aucast::sources {

inline constexpr std::size_t kCsvLineBytesMax = std::size_t{256} << 10U;
inline constexpr std::size_t kCsvColumnsMax = 8192;
/// Characters that are ignored around a cell or a line.
inline constexpr std::string_view kCsvBlanks = " \t\r";

/// Reads a table row by row; columns are found by name, never by position. Accepts LF, CRLF, CR, a
/// UTF-8 byte order mark, a preamble (is_preamble()), blanks around cells, quoted cells, and ',',
/// ';' or tab between cells (whichever the header has most of). The reader refers to the text,
/// which must outlive the reader, and keeps one row at a time. It collects the first 20 errors in
/// rows and numbers.
class CsvReader {
 public:
  enum class Next : std::uint8_t {
    Row,             ///< a row with a cell for every column
    RepeatedHeader,  ///< the header once more: another recording was appended
    Truncated,       ///< a last line without a line end, since its writer was stopped; ignore it
    Faulty,          ///< a line with too few or too many cells; noted in error()
    End,
  };

  /// Reads the line with the names of the columns: the first that is neither blank nor a preamble.
  /// Fails with BadData if there is no such line, or if it is too long or names too many columns.
  /// Once `stop` is requested, next() returns End at once.
  [[nodiscard]] static Result<CsvReader> open(std::string_view text, std::string_view file,
                                              std::stop_token stop = {});

  /// The names of the columns, trimmed.
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  /// The first column of that name. Case matters: OpenFace has both x_0 and X_0.
  [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;

  /// Reads the next line that is not blank.
  [[nodiscard]] Next next();
  /// Whether the reader was asked to stop, so that next() may have left out rows.
  [[nodiscard]] bool stopped() const { return stop_.stop_requested(); }
  /// Makes `content`, such as a line that was just written, the present line. `content` must not be
  /// blank, and must outlive the use of its cells. `line`: its number, for messages.
  [[nodiscard]] Next take(std::string_view content, std::size_t line);
  /// Goes back to before the first row; errors are kept.
  void rewind();

  /// The cell as text, trimmed, without quotes; empty when the table has no such column.
  [[nodiscard]] std::string_view text(std::optional<std::size_t> column) const;
  /// The cell as a number. nullopt when the table has no such column, and for values that mean "no
  /// data": an empty cell, NaN, inf, NA, null, none. A decimal comma and separators of thousands
  /// are understood in a quoted cell, or where cells are separated by ';' or tab. Anything else is
  /// noted in error().
  [[nodiscard]] std::optional<double> number(std::optional<std::size_t> column);

  /// Number of the present line, from 1.
  [[nodiscard]] std::size_t line() const { return line_; }
  /// Adds an error about a cell of this row.
  void refuse(std::optional<std::size_t> column, const std::string& reason);
  [[nodiscard]] bool has_errors() const { return !errors_.empty(); }
  /// All errors noted, one "file:line:column: reason" per line.
  [[nodiscard]] Error error() const { return errors_.error(); }
  /// Returns all errors noted, and forgets them.
  [[nodiscard]] std::vector<std::string> take_errors() { return errors_.take(); }

 private:
  CsvReader(std::string_view text, std::string_view file, std::stop_token stop)
      : text_(text), stop_(std::move(stop)), errors_(file) {}

  [[nodiscard]] Result<void> read_header();
  [[nodiscard]] bool take_line();
  [[nodiscard]] Next read_row();
  void split();
  void refuse_at(std::size_t byte, const std::string& reason);

  std::string_view text_;
  std::stop_token stop_;
  char line_end_ = '\n';
  std::size_t position_ = 0;    ///< of the next line
  std::size_t rows_begin_ = 0;  ///< of the line after the header
  std::size_t rows_line_ = 0;   ///< number of the header's line
  std::size_t line_ = 0;
  std::string_view content_;  ///< the present line
  bool ended_ = false;        ///< the present line has its line feed
  char separator_ = ',';
  std::string header_;
  std::vector<std::string> columns_;
  std::vector<std::string_view> cells_;
  ErrorList errors_;
};

/// Whether a line before a table is to be skipped: "sep=;" for spreadsheets, a comment that begins
/// with '#', or FaceReader's description of a recording ("Face Model:" and so on).
[[nodiscard]] bool is_preamble(std::string_view line);

/// A number as recognisers and spreadsheets write it: 1.5 and, with `commas`, 1,5 and 1,234.5.
/// nullopt when it is not a number or not finite.
[[nodiscard]] std::optional<double> parse_number(std::string_view text, bool commas);

}  // namespace aucast::sources
