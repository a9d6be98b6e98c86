#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/live/history.hpp"
#include "drivers/live/server.hpp"

/// HTTP of the page, without I/O: what a request is answered.
namespace drydock::live {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;
using HttpResponse = boost::beast::http::response<boost::beast::http::string_body>;

std::string text_of(boost::beast::string_view view);

/// With headers that keep other pages from showing it inside themselves.
HttpResponse answer(const HttpRequest& request, boost::beast::http::status status,
                    std::string_view media_type, std::string_view content);

/// A file of the page, the history, 404, or 405 for all methods but GET and HEAD.
HttpResponse answer_to(const HttpRequest& request, const std::vector<PageFile>& page,
                       const History& history);

/// A script or style. It contains no data of the run, and a browser requests it without the token.
bool is_part_of(const std::vector<PageFile>& page, const HttpRequest& request);

}  // namespace drydock::live
