#include "client/app/window/making/au_names.h"

#include "common/text_file.h"

namespace aucast::app {

void AuNames::type(int number, const std::string& name, const std::string& saved) {
  this->saved(number);
  if (name != saved) typed_[number] = name;
}

std::string AuNames::name_for(int number, const std::string& wanted) const {
  if (!wanted.empty()) return wanted;
  const auto typed = typed_.find(number);
  const std::string name =
      typed == typed_.end() ? std::string() : std::string(trimmed(typed->second, " "));
  const auto removed = removed_.find(number);
  return name.empty() && removed != removed_.end() ? removed->second : name;
}

void AuNames::saved(int number) {
  typed_.erase(number);
  removed_.erase(number);
}

void AuNames::removed(int number, const std::string& name) {
  typed_.erase(number);
  if (!name.empty()) removed_[number] = name;
}

std::map<int, std::string> AuNames::view() const {
  std::map<int, std::string> all = typed_;
  all.insert(removed_.begin(), removed_.end());
  return all;
}

}  // namespace aucast::app
