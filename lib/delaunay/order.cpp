// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/order.h"

#include "core/error.h"

namespace crumple::delaunay {
namespace {

struct Entry {
    Order order;
    InsertSites insert;
};

constexpr Entry orders[] = {
    {Order::quickhull, insert_quickhull}, {Order::sampled, insert_sampled}, {Order::brio, insert_brio}};

}

Order choose_order(Order wanted, Index) { return wanted == Order::automatic ? Order::brio : wanted; }

InsertSites insertion_of(Order order) {
    for (const Entry& entry : orders) {
        if (entry.order == order) return entry.insert;
    }
    throw Error(ErrorKind::internal, "delaunay: an order without an entry in the table");
}

}
