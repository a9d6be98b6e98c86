#pragma once

#include <memory>
#include <optional>

#include "drivers/link/pump.hpp"
#include "drivers/shell/line.hpp"

namespace drydock::shell {

/// A line with its kind of link. Subclasses give the content to the devices.
template <class Link>
class LinkedLine : public Line {
 public:
  using Line::Line;

 protected:
  using Item = typename link::Traffic<Link>::Item;
  using Opened = boost::system::result<std::unique_ptr<Link>, link::OpenError>;

  virtual link::Uri next_uri() { return uri(); }  ///< for the next opening
  virtual Opened open(const link::Uri& uri);
  virtual void receive(const Item& item, Stamp at) = 0;

  void put(const Item& item);
  Link& current_link() { return *link_; }

 private:
  boost::system::result<Provenance, link::OpenError> open_link() override;
  Run serve_link() override;
  Run read_until_lost();
  void heard(const Item& item, Stamp at);
  void close_link() override { pump_->close(); }
  void destroy_link() override;
  bool written(const Item& item, const boost::system::error_code& failure);

  std::unique_ptr<Link> link_;
  std::optional<link::Pump<Link>> pump_;
};

extern template class LinkedLine<link::ByteLink>;
extern template class LinkedLine<link::FrameLink>;

}  // namespace drydock::shell
