-- Gravity acts twice in every step
--
-- In one step $v_y$ changed by −0.327 m/s, twice $g \, \Delta t = -0.1635$ m/s. Your ball falls
-- as on a planet with 19.62 m/s². Count the lines of a step that change the velocity.

-- Bouncing ball. Lengths in m, times in s, velocities in m/s, accelerations in m/s².

-- Runs once, when the scene is in place.
function on_load()
  gravity = vec(0, -9.81)
end

-- Symplectic Euler: the velocity from the end of the step moves the ball.
function on_update(timestep)
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
end
