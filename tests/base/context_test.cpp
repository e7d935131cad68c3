// Two computations in one process do not affect each other.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/context.hpp"

#include <gtest/gtest.h>

#include <mutex>
#include <set>
#include <thread>

#include "base/loop.hpp"
#include "base/parallel.hpp"

namespace keyblock::context_test {

TEST(Context, is_stopped_alone) {
  const Context one, other;
  one.stop();
  EXPECT_TRUE(one.is_stopped());
  EXPECT_FALSE(other.is_stopped());
  EXPECT_FALSE(context().is_stopped());
  const Under under(one);
  EXPECT_THROW(leave_if_stopped(), StopRequested);
  EXPECT_THROW(begin_system(), StopRequested);
}

TEST(Context, stops_its_parts_and_is_not_stopped_by_them) {
  const Context whole;
  const Context first = whole.part(), second = whole.part();
  first.stop();
  EXPECT_FALSE(whole.is_stopped());
  EXPECT_FALSE(second.is_stopped());
  whole.stop();
  EXPECT_TRUE(second.is_stopped());
}

TEST(Context, is_that_of_the_innermost_scope) {
  const Context outer, inner;
  const Context* before = &context();
  {
    const Under under_outer(outer);
    {
      const Under under_inner(inner);
      EXPECT_EQ(&context(), &inner);
    }
    EXPECT_EQ(&context(), &outer);
  }
  EXPECT_EQ(&context(), before);
}

TEST(Context, is_handed_on_to_loops_and_threads) {
  const Context own;
  own.use_threads(4);
  const Under under(own);
  const auto expect_own = [&] { ASSERT_EQ(&context(), &own); };
  for_each_entry(40 * kLoopRange, [&](std::size_t) { expect_own(); });
  for_each_in_parallel(4, 2, [&](std::size_t) { expect_own(); });
  at_once(3, [&](std::size_t) { expect_own(); });
}

TEST(Context, ends_at_its_limits) {
  const Context few({.systems = 2});
  few.begin_system();
  few.begin_system();
  EXPECT_THROW(few.begin_system(), StopRequested);
  EXPECT_EQ(few.systems(), 2);
  EXPECT_FALSE(few.is_stopped()) << "a run without linear solves continues";
  EXPECT_TRUE(Context({.seconds = 0}).is_stopped());
  EXPECT_FALSE(Context({.seconds = 1e3}).is_stopped());
}

TEST(Context, counts_the_systems_of_its_parts) {
  const Context whole({.systems = 3});
  const Context part = whole.part({.systems = 2});
  part.begin_system();
  part.begin_system();
  EXPECT_THROW(part.begin_system(), StopRequested);
  EXPECT_EQ(whole.systems(), 2) << "one that is not begun counts nowhere";
  const Context next = whole.part();
  next.begin_system();
  EXPECT_THROW(next.begin_system(), StopRequested);
}

TEST(Context, of_a_whole_tells_the_headway_of_its_parts) {
  const Context whole, other;
  {
    const Context part = whole.part();
    const Under under(part);
    tell_headway("search", 1.5);
  }
  EXPECT_STREQ(whole.headway().what, "search");
  EXPECT_EQ(whole.headway().share, 1);
  EXPECT_EQ(other.headway().what, nullptr);
  whole.tell(nullptr, 0);
  EXPECT_EQ(whole.headway().what, nullptr);
}

TEST(Context, has_threads_of_its_own) {
  const Context one, four;
  one.use_threads(1);
  four.use_threads(4);
  const auto threads_seen = [](const Context& context) {
    std::set<std::thread::id> seen;
    std::mutex guard;
    const Under under(context);
    for_ranges(64 * kLoopRange, [&](std::size_t, std::size_t, std::size_t) {
      const std::scoped_lock lock(guard);
      seen.insert(std::this_thread::get_id());
    });
    return std::pair(seen.size(), loop_threads());
  };
  EXPECT_EQ(threads_seen(one), std::pair(std::size_t{1}, 1));
  EXPECT_LE(threads_seen(four).first, 4U);
  EXPECT_EQ(threads_seen(four).second, 4);
  EXPECT_EQ(threads_seen(four.part()).second, 4);
}

TEST(Headway, a_fall_of_half_the_orders_of_magnitude_is_half_the_way) {
  EXPECT_NEAR(share_of_fall(1, 1e-4, 1e-8), 0.5, 1e-12);
  EXPECT_EQ(share_of_fall(1, 10, 1e-8), 0) << "farther off than at first";
  EXPECT_EQ(share_of_fall(1, 1e-9, 1e-8), 1);
  EXPECT_EQ(share_of_fall(1, 0, 1e-8), 0) << "not known";
  EXPECT_EQ(share_of_fall(1e-9, 1e-9, 1e-8), 0) << "there at once";
}

}  // namespace keyblock::context_test
