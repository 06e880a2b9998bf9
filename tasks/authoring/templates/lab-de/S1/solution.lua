-- Längen in m, Zeiten in s, Geschwindigkeiten in m/s, Beschleunigungen in m/s².

-- Läuft einmal, wenn die Szene steht.
function on_load()
  gravity = vec(0, -9.81)
end

-- Läuft in jedem Schritt; timestep ist seine Dauer.
function on_update(timestep)
  circle1.velocity = circle1.velocity + gravity * timestep
  circle1.position = circle1.position + circle1.velocity * timestep
end
