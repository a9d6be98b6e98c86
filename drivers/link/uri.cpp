#include "drivers/link/uri.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "drivers/capture/format.hpp"
#include "drivers/capture/line_file.hpp"
#include "drivers/link/uri_forms.hpp"

namespace drydock::link {
namespace {

/// The one line of every failure: `"text": what`.
UriError wrong(std::string_view text, const std::string& what) {
  return {"\"" + std::string(text) + "\": " + what};
}

std::string in_quotes(std::string_view text) { return "\"" + std::string(text) + "\""; }

std::string key_names(const Form& form) {
  std::string names;
  for (const Key& key : form.keys)
    if (!key.name.empty()) names += (names.empty() ? "" : " ") + std::string(key.name);
  return names;
}

/// The error in one `key=value` of the query. Empty if there is none.
std::string check_parameter(const Form& form, std::string_view parameter) {
  const std::size_t equals = parameter.find('=');
  const std::string_view name = parameter.substr(0, equals);
  const auto key = std::find_if(form.keys.begin(), form.keys.end(),
                                [&](const Key& k) { return !name.empty() && k.name == name; });
  if (key == form.keys.end())
    return "unknown key " + in_quotes(name) + "; " + std::string(form.name) + " allows " +
           key_names(form);
  if (equals == std::string_view::npos)
    return "key " + in_quotes(name) + " has no value; allowed: " + std::string(key->allowed);
  const std::string_view value = parameter.substr(equals + 1);
  if (!key->valid(value))
    return "bad " + std::string(name) + " " + in_quotes(value) +
           "; allowed: " + std::string(key->allowed);
  return {};
}

std::string parse_query(const Form& form, std::string_view query, Uri& uri) {
  while (!query.empty()) {
    const std::size_t end = query.find('&');
    const std::string_view parameter = query.substr(0, end);
    query = end == std::string_view::npos ? std::string_view{} : query.substr(end + 1);
    if (std::string problem = check_parameter(form, parameter); !problem.empty()) return problem;
    const std::size_t equals = parameter.find('=');
    std::string name(parameter.substr(0, equals)), value(parameter.substr(equals + 1));
    if (name == "mode") std::tie(name, value) = std::pair("listen", "1");  // mode=listen
    if (!uri.query.emplace(name, value).second) return "key " + in_quotes(name) + " is given twice";
  }
  return {};
}

/// Text of the link below a bus of text, with the keys of that link. What a gateway sends by UDP
/// comes to a port of this computer.
std::string line_text(const Uri& bus) {
  const bool is_device = bus.target.starts_with('/');
  std::string text = is_device ? "serial:" + bus.target : bus.target;
  const bool has_baud = text.starts_with("serial:") || text.starts_with("pty:");
  if (has_baud) text += "?baud=" + std::to_string(bus.baud().value_or(115'200));
  if (bus.scheme == Scheme::gateway && text.starts_with("udp:")) text += "?listen=1";
  return text;
}

std::string check_line_under(const Uri& uri) {
  const auto line = parse_uri(line_text(uri));
  if (line && line->carries() == Carries::bytes && line->scheme != Scheme::file) return {};
  const Form& form = form_of(uri.scheme);
  return std::string(form.name) +
         " needs a device path or one of serial: pty: tcp: udp: memory: after it, for example " +
         std::string(form.example);
}

/// Checks the query as a whole, after its single values.
std::string check_whole(const Uri& uri) {
  if (uri.scheme == Scheme::serial && uri.text_of("baud").empty())
    return "serial needs a baud rate, for example " + std::string(form_of(uri.scheme).example);
  if (uri.text_of("bits") == "5" && uri.text_of("stop") == "2")
    return "a byte of 5 bits has no 2 stop bits; allowed: stop=1";
  if (uri.text_of("flow") == "rtscts" && !uri.text_of("rts").empty())
    return "with flow=rtscts the port itself sets RTS: leave out rts";
  if (uri.text_of("flow") == "rtscts" && !uri.text_of("rs485").empty())
    return "RS-485 has no flow=rtscts: RTS switches the transmitter";
  if (uri.searches_bit_rate() && !uri.only_listens())
    return "bitrate=auto only listens, since an adapter that is active at a wrong rate disturbs "
           "the "
           "bus: add listen=1, or give the rate";
  return has_line_under(uri) ? check_line_under(uri) : std::string();
}

const Form* find_form(std::string_view name) {
  for (const Form& form : uri_forms())
    if (form.name == name) return &form;
  return nullptr;
}

/// A % without two hexadecimal digits stands for itself.
std::string without_escapes(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned char byte = 0;
    const char* const end = text.data() + std::min(i + 3, text.size());
    if (text[i] == '%' &&
        std::from_chars(text.data() + i + 1, end, byte, 16).ptr == text.data() + i + 3) {
      plain += static_cast<char>(byte);
      i += 2;
    } else {
      plain += text[i];
    }
  }
  return plain;
}

}  // namespace

std::string allowed_schemes() {
  std::string names;
  for (const Form& form : uri_forms()) names += (names.empty() ? "" : " ") + std::string(form.name);
  return names;
}

std::string file_uri(std::string_view path) {
  std::string text = "file:";
  for (const char c : path)
    if (c == '?' || c == '%')
      text += c == '?' ? "%3F" : "%25";
    else
      text += c;
  return text;
}

boost::system::result<Uri, UriError> parse_uri(std::string_view text) {
  const std::size_t question = text.find('?');
  const std::string_view address = text.substr(0, question);
  const std::string_view query =
      question == std::string_view::npos ? std::string_view{} : text.substr(question + 1);
  const bool is_auto = address == form_of(Scheme::can_auto).name;
  const std::size_t colon = is_auto ? address.size() : address.find(':');
  if (colon == std::string_view::npos)
    return wrong(text, "a link is scheme:target; schemes are " + allowed_schemes());

  const Form* form = find_form(address.substr(0, colon));
  if (form == nullptr)
    return wrong(text, "unknown scheme " + in_quotes(address.substr(0, colon)) + "; allowed are " +
                           allowed_schemes());
  Uri uri;
  uri.scheme = form->scheme;
  uri.text = text;
  if (std::string problem = parse_query(*form, query, uri); !problem.empty())
    return wrong(text, problem);
  const auto name = uri.query.find("name");
  if (is_auto)
    uri.target = name == uri.query.end() ? "vcan0" : name->second;
  else
    uri.target = address.substr(colon + 1);
  if (uri.recorded()) uri.target = without_escapes(uri.target);
  if (!form->valid_target(uri.target))
    return wrong(text, std::string(form->name) + " needs " + std::string(form->target) +
                           ", for example " + std::string(form->example));
  if (std::string problem = check_whole(uri); !problem.empty()) return wrong(text, problem);
  const std::string_view format = uri.text_of("format");
  if (uri.scheme == Scheme::gateway && !format.empty() && format != "ydwg")
    uri.query["listen"] = "1";  // the others take no frames
  return uri;
}

std::string recording_misfit(const Uri& file, Carries what) {
  const std::string_view format = file.text_of("format");
  std::string problem;
  if (what == Carries::frames && format == "raw")
    problem = "format=raw is for bytes; for CAN frames there are " + capture::format_names();
  if (what == Carries::bytes && !format.empty() && format != "raw")
    problem = "format=" + std::string(format) + " is for CAN frames; for bytes there is raw";
  for (const std::string_view key : {"bitrate", "data_bitrate"})
    if (what == Carries::bytes && !file.text_of(key).empty())
      problem = std::string(key) + " is for CAN frames; the rate of a line of bytes is baud";
  if (what == Carries::bytes && file.speed().value_or(0) > 0 && !file.baud() &&
      file.text_of("clock") != "device" && !capture::has_times(file.target))
    problem = "speed=" + std::string(file.text_of("speed")) +
              " needs the baud rate of the recorded line or clock=device, for example " +
              std::string(form_of(Scheme::file).example);
  return problem.empty() ? problem : in_quotes(file.text) + ": " + problem;
}

Uri listening(Uri uri) {
  if (uri.carries() == Carries::frames) uri.query["listen"] = "1";
  return uri;
}

Uri line_under(const Uri& bus) { return parse_uri(line_text(bus)).value(); }

bool has_line_under(const Uri& uri) {
  return uri.scheme == Scheme::slcan || uri.scheme == Scheme::gateway;
}

Carries Uri::carries() const { return scheme <= Scheme::memory ? Carries::bytes : Carries::frames; }

bool Uri::emulated() const {
  switch (scheme) {
    case Scheme::pty:
    case Scheme::memory:
    case Scheme::memory_can:
    case Scheme::can_auto: return true;
    case Scheme::socketcan: return target.starts_with("vcan") || flag("emulated");
    case Scheme::slcan:
    case Scheme::gateway: return flag("emulated") || line_under(*this).emulated();
    default: return flag("emulated");
  }
}

std::string_view Uri::text_of(std::string_view key) const {
  const auto found = query.find(std::string(key));
  return found == query.end() ? std::string_view{} : std::string_view(found->second);
}

bool Uri::flag(std::string_view key) const { return text_of(key) == "1"; }

std::optional<double> Uri::speed() const {
  const std::string_view written = text_of("speed");
  double factor = 0;  // "max"
  std::from_chars(written.data(), written.data() + written.size(), factor);
  return written.empty() ? std::nullopt : std::optional(factor);
}

namespace {

std::optional<unsigned> number(const Uri& uri, const char* key) {
  const auto found = uri.query.find(key);
  if (found == uri.query.end()) return std::nullopt;
  unsigned value = 0;
  std::from_chars(found->second.data(), found->second.data() + found->second.size(), value);
  return value;
}

}  // namespace

std::optional<unsigned> Uri::baud() const {
  return text_of("baud") == "auto" ? std::nullopt : number(*this, "baud");
}

wire::ByteFrame Uri::byte_frame() const {
  wire::ByteFrame frame;
  frame.data_bits = number(*this, "bits").value_or(frame.data_bits);
  frame.parity = parity_of(text_of("parity")).value_or(frame.parity);
  frame.stop_bits = number(*this, "stop").value_or(frame.stop_bits);
  return frame;
}

std::optional<wire::LineRate> Uri::line_rate() const {
  const auto bits_per_second = baud();
  if (!bits_per_second) return std::nullopt;
  return wire::LineRate(*bits_per_second, byte_frame());
}

std::optional<unsigned> Uri::bitrate() const {
  if (!may_carry(Carries::frames)) return std::nullopt;
  constexpr unsigned usual = 250'000;
  return searches_bit_rate() ? usual : number(*this, "bitrate").value_or(usual);
}

std::optional<unsigned> Uri::data_bitrate() const { return number(*this, "data_bitrate"); }

void throw_exception_from_error(const UriError& error, const boost::source_location&) {
  throw std::invalid_argument(error.message);
}

}  // namespace drydock::link
