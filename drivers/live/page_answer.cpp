#include "drivers/live/page_answer.hpp"

#include <algorithm>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include "drivers/live/foxglove/access.hpp"

namespace drydock::live {

namespace beast = boost::beast;
namespace http = beast::http;

std::string text_of(beast::string_view view) { return {view.data(), view.size()}; }

HttpResponse answer(const HttpRequest& request, http::status status, std::string_view media_type,
                    std::string_view content) {
  HttpResponse response{status, request.version()};
  response.set(http::field::content_type, {media_type.data(), media_type.size()});
  response.set(http::field::cache_control, "no-store");
  response.set("X-Content-Type-Options", "nosniff");
  // No other page may show this one inside itself and let a visitor click on it unseen.
  response.set("X-Frame-Options", "DENY");
  response.set("Content-Security-Policy",
               "default-src 'self'; connect-src 'self' ws: wss:; style-src 'self' 'unsafe-inline'; "
               "frame-ancestors 'none'");
  if (request.method() == http::verb::get) response.body() = content;
  response.keep_alive(request.keep_alive());
  response.prepare_payload();
  return response;
}

HttpResponse answer_to(const HttpRequest& request, const std::vector<PageFile>& page,
                       const History& history) {
  if (request.method() != http::verb::get && request.method() != http::verb::head)
    return answer(request, http::status::method_not_allowed, "text/plain", "GET only\n");
  const std::string target = text_of(request.target());
  const auto path = path_of(target);
  if (path == "/history")
    return answer(request, http::status::ok, "application/octet-stream", history.file());
  const auto file = std::ranges::find(page, path, &PageFile::path);
  return file == page.end() ? answer(request, http::status::not_found, "text/plain", "not here\n")
                            : answer(request, http::status::ok, file->media_type, file->content);
}

bool is_part_of(const std::vector<PageFile>& page, const HttpRequest& request) {
  const std::string target = text_of(request.target());
  const auto path = path_of(target);
  return path != "/" && !beast::websocket::is_upgrade(request) &&
         std::ranges::find(page, path, &PageFile::path) != page.end();
}

}  // namespace drydock::live
