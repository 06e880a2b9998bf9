-- Springender Ball.
-- Längen in m, Zeiten in s, Geschwindigkeiten in m/s,
-- Beschleunigungen in m/s².

-- Läuft einmal, wenn die Szene aufgestellt ist.
function on_load()
  -- Gib gravity hier ihren Wert.
end

-- Läuft in jedem Schritt; timestep ist seine Dauer.
function on_update(timestep)
  -- Erst soll gravity die Geschwindigkeit von circle1 ändern,
  -- dann diese Geschwindigkeit ihn bewegen.
end
